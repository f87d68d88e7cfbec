"""Certain references, stress strata and certificates: how wrong each public function can be, measured in ulps."""
