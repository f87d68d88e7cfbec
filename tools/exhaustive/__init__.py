"""Every primitive at every binary32 input, the same bits from every version, and the hardest inputs."""
