"""What the papers leave open: the second root, pure numbers, slopes and hills, the inverse problem, the envelope."""
