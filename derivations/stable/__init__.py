"""The well-conditioned twin of each emitted formula, proved equal to the printed one."""
