"""The derivations: one script for each section of a paper, from the laws on."""
