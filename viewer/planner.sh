#!/usr/bin/env bash
# Compiles the planner of the page to `viewer/planner/`. Needs rustup, or a Rust with the target installed.
set -eu
cd "$(dirname "$0")/.."
target=wasm32-unknown-unknown
bindgen=$(sed -n 's/^wasm-bindgen = "=\([0-9.]*\)".*/\1/p' Cargo.toml)
tools="$PWD/target/tools/wasm-bindgen-$bindgen"

if command -v rustup >/dev/null; then rustup target add "$target"; fi
[ -x "$tools/bin/wasm-bindgen" ] || cargo install --locked "wasm-bindgen-cli@$bindgen" --root "$tools"

# Messages of panics name sources; without this, they would name folders of the machine that compiles.
remapped=
for folder in "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*; do remapped="$remapped --remap-path-prefix=$folder/="; done
CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="$remapped" cargo build --locked -p cdpr-live --profile page --target "$target"
"$tools/bin/wasm-bindgen" --target web --no-typescript --out-dir viewer/planner --out-name planner \
	"target/$target/page/cdpr_live.wasm"
viewer/node_modules/.bin/wasm-opt -Os --low-memory-unused --reorder-functions --reorder-locals --enable-bulk-memory --enable-nontrapping-float-to-int \
	--enable-sign-ext --enable-mutable-globals --enable-reference-types --enable-multivalue \
	viewer/planner/planner_bg.wasm -o viewer/planner/planner.wasm
