"""From the stable forms to NumPy and C99: schedule, print, write."""
