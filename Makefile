# `make test` sets up everything it needs (except Rust and Python 3.11 or later) and runs every test.
PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
BIN := $(VENV)/bin
WHEELS := target/wheels

SITE := target/site

# A first build is a third faster without; while editing the core, `make test CARGO_INCREMENTAL=1` may be faster.
CARGO_INCREMENTAL ?= 0
export CARGO_INCREMENTAL

.PHONY: test checked lint rust-test long-test portable-test mutation-test optimised-test wasm-check verify fuzz program wheel release-wheel python-test python-long-test \
	package-test release-check release-fill notices reference docs workflows packages deny demo figures reproduction bench viewer page browser clean

test: checked rust-test python-test docs workflows

# The code is checked and the Python packages arrive while the tests are compiled.
checked:
	@$(MAKE) --no-print-directory --jobs 3 lint program $(VENV)/ready

# Tests that take too long for everyday use, after `make test`.
long-test: mutation-test optimised-test portable-test python-long-test wasm-check

# Formatting, lints, and documentation without broken links: warnings are errors. With a directory of its own, cargo does not wait for
# what else is compiled.
LINTED := target/lint

lint:
	cargo fmt --all --check
	cargo clippy --workspace --all-targets --locked --target-dir $(LINTED) -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --locked --quiet --target-dir $(LINTED)

# Ends a test binary that hangs, if coreutils are installed; by then libtest has named the test, as it does for every
# test that runs over 60 s. `--foreground` lets Ctrl-C through.
TEST_SECONDS := 1800
ifneq ($(shell command -v timeout),)
LIMITED := --config "target.'cfg(all())'.runner = 'timeout --foreground --verbose $(TEST_SECONDS)'"
endif

# Unit, property and integration tests, then the examples in the documentation. Benchmarks and examples of programs have no
# tests; clippy checks that they compile. Everywhere the same packages are named: others would be compiled again, with other features.
TESTED := --workspace --exclude cdpr-benches

rust-test:
	cargo test $(LIMITED) $(TESTED) --tests --locked
	cargo test $(LIMITED) $(TESTED) --doc --locked

# Damaged files for every reader, three times as many as in `make test`; damaged meshes against plain readers, 50 000 of each
# kind.
mutation-test:
	CDPR_FUZZ_CASES=3 cargo test $(LIMITED) $(TESTED) --locked --test mutations
	CDPR_FUZZ_CASES=3 cargo test $(LIMITED) $(TESTED) --locked --test files mesh_mutations

# Our crates without debug assertions and optimised as users run them.
OPTIMISED := --config tests/optimised.toml

# Engines and solvers, optimised; more damaged certificates; large meshes.
optimised-test:
	cargo test $(LIMITED) $(OPTIMISED) $(TESTED) --locked --test oracles --test bounds -- --include-ignored
	cargo test $(LIMITED) $(OPTIMISED) $(TESTED) --locked --test files mesh_parts -- --include-ignored

# Everything that depends on the kernels once more with the portable ones, as on a machine without AVX2.
portable-test:
	CDPR_PORTABLE=1 cargo test $(LIMITED) $(OPTIMISED) $(TESTED) --locked --test oracles

# The core and the planner of the page must build for the browser; skipped if rustup has not installed that target.
WASM := wasm32-unknown-unknown

wasm-check:
	@if rustc --print target-libdir --target $(WASM) | xargs test -d; \
	then cargo check --locked -p cdpr-core -p cdpr-live --target $(WASM); else echo "no target $(WASM): not checked"; fi

# Both engines and exact tests on 2 million random and degenerate motions, 2 million states and motions in and around bodies of
# several parts, 2 million motions with a turn, margins and linear programs on 300 000 poses; every disagreement is printed.
verify:
	CDPR_VERIFY=60 cargo test --release --locked -p cdpr-tests --test oracles -- engines_agree --nocapture
	CDPR_VERIFY=60 cargo test --release --locked -p cdpr-tests --test oracles -- lattice --nocapture
	CDPR_VERIFY=190 cargo test --release --locked -p cdpr-tests --test oracles -- turning::free_motions --nocapture
	CDPR_VERIFY=10 cargo test --release --locked -p cdpr-tests --test oracles -- wrench_oracle --nocapture

# Coverage-guided fuzzing of every reader, FUZZ_SECONDS each; needs a C++ compiler, see fuzz/README.md. The corpus
# stays in target/fuzz, so that the next run continues from there. `make fuzz FUZZ_READERS=mesh_stl` fuzzes one.
FUZZ_SECONDS ?= 600
FUZZ_READERS ?= $(notdir $(wildcard fuzz/seeds/*))
FUZZ_HOST = $(shell rustc -vV | sed -n 's/^host: //p')
FUZZ_FLAGS := -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
	-Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
	-Cllvm-args=-sanitizer-coverage-trace-compares --cfg fuzzing

fuzz:
	RUSTFLAGS="$(FUZZ_FLAGS)" cargo build --locked --profile fuzz -p cdpr-fuzz --features libfuzzer \
		--target $(FUZZ_HOST) --target-dir target/fuzzing
	@set -e; for reader in $(FUZZ_READERS); do \
		mkdir -p target/fuzz/$$reader fuzz/regressions/$$reader; echo "== $$reader"; \
		CDPR_FUZZ=$$reader target/fuzzing/$(FUZZ_HOST)/fuzz/fuzz_reader -max_total_time=$(FUZZ_SECONDS) -timeout=60 \
			-rss_limit_mb=2048 -max_len=100000 -dict=fuzz/dictionary.txt -artifact_prefix=target/fuzz/$$reader- \
			-print_final_stats=1 target/fuzz/$$reader fuzz/seeds/$$reader fuzz/regressions/$$reader; \
	done

$(VENV)/ready: requirements-dev.txt requirements-docs.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements-dev.txt -r requirements-docs.txt
	touch $@

# Builds the wheel in a profile and installs it.
define install_wheel
rm -rf $(WHEELS)
$(BIN)/maturin build --profile $(1) --locked --out $(WHEELS)
$(BIN)/python -m pip install --quiet --disable-pip-version-check --force-reinstall --no-deps $(WHEELS)/*.whl
endef

# A wheel in the tests' own profile, with every check of a debug build, in its own environment.
wheel: $(VENV)/ready
	$(call install_wheel,dev)

# The wheel as users install it.
release-wheel: $(VENV)/ready
	$(call install_wheel,dist)

# The browser for the tests of the page: an existing one; as root on Debian, one is installed; otherwise these tests are
# skipped, or fail if CI is set.
browser:
	@[ -n "$$CDPR_CHROMIUM" ] || command -v chromium || command -v google-chrome || command -v chromium-browser || \
		{ [ "$$(id -u)" = 0 ] && [ -e /etc/debian_version ] && apt-get update -q && apt-get install -qy chromium; } || \
		echo "no Chromium: install the package chromium or Google Chrome, or name its program in CDPR_CHROMIUM"

# The program as the tests use it, target/debug/cdpr; up to date after the tests.
program:
	cargo test $(TESTED) --tests --locked --no-run --quiet

# Examples of docstrings, in an empty folder: they need nothing but the package.
DOCTESTS = folder=$$(mktemp -d) && cd "$$folder" && \
	$(CURDIR)/$(BIN)/python -m pytest -c $(CURDIR)/pyproject.toml --rootdir "$$folder" --doctest-modules --pyargs cdpr

# One process per core; tests of one file stay together if they share data that takes long to make.
PARALLEL := -n auto --dist worksteal

python-test: wheel browser program
	$(BIN)/python -m mypy python/cdpr
	$(BIN)/python -m mypy.stubtest cdpr --mypy-config-file pyproject.toml --allowlist python/stubtest-allowlist.txt
	$(BIN)/python -m pytest $(PARALLEL) -m "not sdist and not long" python/tests
	$(DOCTESTS)

# Python tests marked "long", also of the package in an environment of its own. `make release-check` tests the wheel as published.
python-long-test: wheel browser program
	$(BIN)/python -m pytest $(PARALLEL) -m "long and not sdist" python/tests

# Wheel and source archive, each installed into a fresh environment outside the checkout, in which a scene is planned;
# the source archive is built from scratch, which takes some minutes.
package-test: release-wheel
	$(BIN)/python -m pytest -m "sdist or not sdist" python/tests/test_package.py

# The generated pages of docs/reference (from help, schemas and docstrings); they are under version control.
reference: wheel program
	CDPR=target/debug/cdpr $(BIN)/python docs/reference/make.py

# The documentation as a site, in target/site/index.html; warnings are errors.
docs: wheel
	$(BIN)/python -m sphinx -W --keep-going -q -j auto -d target/doctrees docs $(SITE)
	RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --locked --quiet --target-dir $(LINTED)
	rm -rf $(SITE)/rust && cp -r $(LINTED)/doc $(SITE)/rust

# Checks workflows, issue forms and citation against their schemas, offline.
workflows: $(VENV)/ready
	$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	$(BIN)/check-jsonschema --builtin-schema vendor.github-issue-forms $(filter-out %/config.yml,$(wildcard .github/ISSUE_TEMPLATE/*.yml))
	$(BIN)/check-jsonschema --builtin-schema vendor.github-issue-config .github/ISSUE_TEMPLATE/config.yml
	$(BIN)/check-jsonschema --builtin-schema vendor.citation-file-format CITATION.cff

# Whether everything can be published: metadata, crates, sdist and wheel, each installed outside the checkout. Lists faults and
# what nobody has decided yet, such as addresses. It builds the program and the wheel, optimised fully.
release-check: $(VENV)/ready
	$(BIN)/python release/check.py

# Only its part about the crates: each packed, and the program built from the packed crates.
packages:
	$(PYTHON) release/check.py crates

# Writes what is decided in release/decisions.toml to the files that repeat it.
release-fill:
	$(PYTHON) release/decisions.py

# The licences of everything compiled in, which wheel, programs and page bring with them; after a change of Cargo.lock.
notices:
	$(PYTHON) release/notices.py

# Licences, sources, duplicate crates and known vulnerabilities of all dependencies; compiles cargo-deny the first time.
deny:
	cargo deny --version >/dev/null 2>&1 || cargo install --locked cargo-deny@0.20.2
	cargo deny --workspace check

# Plan the paper's scene; writes path.json and view.html.
demo:
	cargo run --release --locked -p cdpr-cli -- plan testdata/scenes/hard1.toml -o path.json --html view.html

# All figures of the documentation, drawn by cdpr.figures; the experiments behind them take some minutes.
# `make figures FIGURES="fig3 fig5"` draws some of them.
figures: release-wheel browser
	$(BIN)/python docs/figures/make.py $(FIGURES)

# Runs the experiments behind docs/reproduction.md and fills its tables; a run that has been interrupted continues.
REPRODUCTION := $(patsubst docs/reproduction/results/%.json,%,$(wildcard docs/reproduction/results/*.json))
reproduction: $(VENV)/ready
	cargo build --release --locked -p cdpr-cli
	for name in $(REPRODUCTION); do \
		target/release/cdpr batch experiments/$$name.toml -o target/reproduction/$$name --resume || exit; \
	done
	$(BIN)/python docs/reproduction/make.py target/reproduction

bench:
	cargo bench --locked -p cdpr-benches

# Rebuilds the page's script from viewer/src and its planner from the core; needs Node and, for WebAssembly, rustup. The
# results are under version control, with checksums of their sources. `make page` rebuilds only the script.
viewer: page
	viewer/planner.sh
	cd viewer && npm run planner

page:
	cd viewer && npm ci && npm run build

clean:
	rm -rf target $(VENV) viewer/node_modules path.json view.html
