"""Aguiar, Soares and Tort 2014, "Galileo's kinematical paradox and the role of resistive forces"."""
