# galileo-sym: `make` installs into .venv and runs everything; `make test` installs and runs the tests.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed
BUILT_OF := CMakeLists.txt $(wildcard generated/c/*.[ch] generated/extension/*.[ch])

.DEFAULT_GOAL := all
.PHONY: all install test mutants coverage tables exhaustive same-bits singles hard-cases prove prove-check sanitize large-samples bench scene-blocks lint format clean help

all: install ## install, then derive, emit and verify everything
	@command -v "$${CC:-cc}" >/dev/null 2>&1 || command -v gcc >/dev/null 2>&1 || command -v clang >/dev/null 2>&1 \
	  || echo "no C compiler found: the NumPy back end alone is built and verified (install gcc or clang for the C one)"
	$(BIN)/galileo-sym all

install: $(STAMP) ## make .venv with the package and its extras

$(STAMP): pyproject.toml $(BUILT_OF)
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[all,test,lint]'
	@touch $(STAMP)

test: install ## run the tests, in parallel
	$(BIN)/python -m pytest -n 2 --dist loadgroup

mutants: install ## change every statement and every premise in one place at a time: no mutant may survive
	$(BIN)/python tools/mutation_run.py --processes 2

tables: install ## fit the primitives' coefficients again; the same bytes unless a definition changed
	$(BIN)/python -m galileo_sym.primitives.remake

exhaustive: install ## try the binary32 primitives at all 2^32 inputs; goes on where it was interrupted
	$(BIN)/python tools/exhaustive/run.py

same-bits: install ## hold every version of the primitives, by gcc and clang, to the same bits
	$(BIN)/python tools/exhaustive/same_bits.py

singles: install ## hold the quick binary32 primitives to those by pairs, at all 2^32 inputs
	$(BIN)/python tools/exhaustive/singles.py

SEED ?= 1
hard-cases: install ## look for inputs worse than those in tests/data; another SEED tries others
	$(BIN)/python tools/exhaustive/hard_cases.py --seed $(SEED)

coverage: install ## hold docs/coverage.md against a run of every derivation
	$(BIN)/python tools/coverage_page.py

prove: install ## prove the error bounds of primitives and tables from the emitted C, and write them down
	$(BIN)/python -m galileo_sym.verify.proof
	$(BIN)/python -m galileo_sym.verify.proof.scaled_command

sanitize: install ## run the extension's tests with AddressSanitizer and UndefinedBehaviorSanitizer
	$(BIN)/python tools/sanitizers/run.py

prove-check: install ## refuse proved bounds that are of another C
	$(BIN)/python -m galileo_sym.verify.proof --check
	$(BIN)/python -m galileo_sym.verify.proof.scaled_command --check

large-samples: install ## verify every public function at 100000 points a stratum; goes on where it was interrupted
	$(BIN)/python tools/large_samples.py

bench: install ## measure run time against error, beside peers, and renew docs/benchmark.md and its plot
	$(BIN)/galileo-sym bench --peers --publish

scene-blocks: install ## reduce a grid of 10^10 points block by block, and write another one to files; docs/scene_blocks.md
	$(BIN)/python tools/scene_blocks.py --write

lint: install ## style, floors of the architecture, the README's accuracy table
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python tools/check_floors.py
	$(BIN)/python tools/accuracy_table.py

format: install ## put the sources into the common style
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

clean: ## remove what is made: .venv, build/, caches
	rm -rf $(VENV) build dist .pytest_cache .ruff_cache .hypothesis .import_linter_cache .benchmarks
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

help: ## list the targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | awk -F ':.*## ' '{printf "make %-13s %s\n", $$1, $$2}'
