"""Packel and Yuen 2004, "Projectile motion with resistance and the Lambert W function"."""
