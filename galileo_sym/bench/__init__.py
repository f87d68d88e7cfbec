"""Run time against error: the emitted code beside what else there is, in one run of interleaved rounds."""
