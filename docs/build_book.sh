#!/bin/sh
# Builds the book into build/docs: html/index.html, cs550.pdf, and site/ with both for a static host. Run by
# `./cs550 docs`, which has installed the tools and built the program that draws the figures.
#
#   docs/build_book.sh FIGURE_PROGRAM [VIEWER]
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
cd "$root"
figure_program=$1
viewer=${2-}
docs=build/docs
mathjax=/usr/share/javascript/mathjax

# begin WHAT: prints which part of the book is made, since all parts together take minutes.
parts=6
begun=0
begin() {
  begun=$((begun + 1))
  echo "[$begun/$parts] $1"
}

# plot_figure NAME FILE: a table that a student's code cannot fill has the reason in its first line.
plot_figure() {
  table=$(sed -n 's|.*data \. "/\(.*\)\.dat".*|\1|p' "docs/figures/plots/$1.gp")  # that of another plot
  reason=$(sed -n '1s/^# unwritten: //p' "$docs/data/${table:-$1}.dat")
  if [ -z "$reason" ]; then
    gnuplot -e "data='$docs/data'; name='$1'; output='$2'" docs/figures/plots/style.gp "docs/figures/plots/$1.gp" && return
    [ ! -d solutions ] || return 1
    reason="Its numbers cannot be plotted. See ./cs550 lab N."
  fi
  "$figure_program" --unwritten "$reason" --output "$2"
}

# What the figure program draws and measures. Some tables are times per step: nothing else may run.
measure() {
  rm -rf "$docs/figures"
  mkdir -p "$docs/figures" "$docs/data"
  "$figure_program" --data "$docs/data" --figures "$docs/figures"
}

# The other figures: one line of figures.txt each, a name and how it is made.
draw_figures() {
  while read -r name tool arguments; do
    file=$docs/figures/$name.svg
    case $name in '' | '#'*) continue ;; esac
    case $tool in
      draw) ;;
      live) "$figure_program" --live "$arguments" --output "$file" ;;
      plot) plot_figure "$name" "$file" ;;
      diagram) dot -Tsvg "docs/figures/diagrams/$name.dot" -o "$file" ;;
      view)
        [ -n "$viewer" ] || continue
        file=$docs/figures/$name.png
        # A student's code may never end: the limit is processor time in seconds.
        (ulimit -t 300; exec "$viewer" $arguments --snapshot "$file" </dev/null >/dev/null) || rm -f "$file" ;;
      *) echo "figures.txt: $name is made by '$tool', which nobody knows" >&2; return 1 ;;
    esac
    [ ! -s "$file" ] || continue
    [ "$tool" = view ] && [ ! -d solutions ] || { echo "figures.txt: nothing has drawn $name" >&2; return 1; }
  done <docs/figures/figures.txt
  # Only a students' copy has figures that its code cannot draw.
  if [ -d solutions ] && grep -l 'drawn by your own code' "$docs"/figures/*.svg >&2; then return 1; fi
  for figure in labs/lab*/figure*.svg; do
    lab=${figure#labs/}
    name=${figure##*/figure}
    cp "$figure" "$docs/figures/${lab%%_*}$name"
  done
}

# The engine for the browser, which live figures run, where emscripten is installed. It is compiled while figures are
# drawn and Doxygen runs. CS550_LIVE_FIGURES=off leaves it out, so that published pages do not contain the reference.
start_live_engine() {
  rm -f "$docs/live_engine.js" "$docs/live.js"
  compiling=
  [ "${CS550_LIVE_FIGURES-on}" != off ] || return 0
  command -v emcmake >/dev/null || return 0
  launcher=
  ! command -v ccache >/dev/null || launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  # CMake refuses the folder of a project that was moved or copied.
  source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' build/live/CMakeCache.txt 2>/dev/null) || source=
  [ "$source" -ef docs/live ] || rm -rf build/live
  export NODE_PATH="${NODE_PATH-/usr/share/nodejs}"  # the distribution's emscripten finds its parser there
  (emcmake cmake -S docs/live -B build/live -G Ninja -DCMAKE_BUILD_TYPE=Release $launcher &&
    exec ninja -C build/live) >"$docs/live.log" 2>&1 &
  compiling=$!
  : >"$docs/live_engine.js"  # the pages are made for it
  trap 'kill "$compiling" 2>/dev/null || true' EXIT
  trap 'exit 1' INT TERM
}

# Two scripts: live_engine.js, a function that is the source of a worker, and live.js.
finish_live_engine() {
  [ -n "$compiling" ] || return 0
  begin "Compiling the live figures $(sed -n 's/^\(\[[0-9]*\/[0-9]*\]\).*/\1/p' "$docs/live.log" | tail -n 1)"
  wait "$compiling" || {
    cat "$docs/live.log" >&2
    echo "The live figures cannot be compiled. To leave them out: CS550_LIVE_FIGURES=off ./cs550 docs" >&2
    return 1
  }
  trap - EXIT INT TERM
  # The hull library is native: the browser's engine lists the point clouds of all scenes, the native one answers.
  node -e "require(process.argv[1])().then(engine =>
    process.stdout.write(engine.ccall('live_clouds', 'string', [], [])))" "$root/build/live/live_engine.js" \
    >"$docs/data/clouds.json"
  "$figure_program" --hulls "$docs/data/clouds.json" --output "$docs/data/hulls.json"
  {
    echo 'function cs550LiveWorker() {'
    cat build/live/live_engine.js
    printf "\nconst hulls = '%s';\n" "$(cat "$docs/data/hulls.json")"
    cat docs/live/worker.js
    echo '}'
  } >"$docs/live_engine.js"
  {
    echo "'use strict'; (() => {"
    cat docs/live/engine.js docs/live/painter.js docs/live/pointer.js docs/live/live.js
    echo '})();'
  } >"$docs/live.js"
}

# The parts of MathJax that the pages use: 2 MB of 54.
copy_mathjax() {
  for part in MathJax.js extensions jax/element jax/input/TeX jax/output/SVG; do
    mkdir -p "$docs/html/mathjax/$(dirname "$part")"
    cp -RL "$mathjax/$part" "$docs/html/mathjax/$(dirname "$part")/"
  done
}

print_pdf() {
  for browser in chromium chromium-browser google-chrome; do
    "$browser" --version >/dev/null 2>&1 && break  # Ubuntu's package holds a script that asks for a snap
    browser=
  done
  if [ -z "$browser" ]; then
    echo "No PDF: that needs a browser that starts. Debian: apt-get install chromium"
    return
  fi
  python3 docs/tools/make_print.py "$docs"
  profile=$(mktemp -d)
  sandbox=
  [ "$(id -u)" != 0 ] || sandbox=--no-sandbox  # the browser refuses root otherwise
  "$browser" --headless $sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --user-data-dir="$profile" --virtual-time-budget=60000 \
    --no-pdf-header-footer --print-to-pdf="$root/$docs/cs550.pdf" "file://$root/$docs/html/print.html" \
    >"$docs/pdf.log" 2>&1 || { cat "$docs/pdf.log" >&2; return 1; }
  rm -rf "$profile" "$docs/html/print.html"
}

# What a static host serves. Files are not filtered there: GitHub Pages would leave out some without .nojekyll.
write_site() {
  rm -rf "$docs/site"
  cp -R "$docs/html" "$docs/site"
  : >"$docs/site/.nojekyll"
  [ ! -s "$docs/cs550.pdf" ] || cp "$docs/cs550.pdf" "$docs/site/"
}

rm -rf "$docs/html" "$docs/cs550.pdf"  # where no PDF is printed, that of an older book would be listed
mkdir -p "$docs"
begin "Measuring, and drawing what the engine draws"
measure
start_live_engine
begin "Drawing the other figures"
draw_figures
begin "Running Doxygen"
python3 docs/tools/make_pages.py "$docs/pages"
# Doxygen fails at a link that leads nowhere, as this one does once its build folder has been removed.
[ -e compile_commands.json ] || rm -f compile_commands.json
doxygen docs/Doxyfile
begin "Indexing the pages for the search"
python3 docs/tools/make_search.py "$docs"
python3 docs/tools/drop_mathjax.py "$docs/html"
cp -R "$docs/figures" "$docs/html/figures"
copy_mathjax
begin "Printing the PDF"
print_pdf
finish_live_engine
[ ! -f "$docs/live_engine.js" ] || cp "$docs/live_engine.js" "$docs/live.js" "$docs/html/"
write_site

echo "$docs/html/index.html: $(find "$docs/html" -maxdepth 1 -name '*.html' | wc -l) pages," \
  "$(find "$docs/figures" -type f | wc -l) figures"
if [ "${CS550_LIVE_FIGURES-on}" = off ]; then
  echo "  without live figures: CS550_LIVE_FIGURES is off"
elif [ ! -f "$docs/live_engine.js" ]; then
  echo "  without live figures: ./cs550 doctor --install live"
fi
[ -n "$viewer" ] || echo "  without pictures of the viewer: ./cs550 doctor --install viewer"
[ ! -s "$docs/cs550.pdf" ] || echo "$docs/cs550.pdf"
echo "$docs/site: the same for a static host, $(du -sm "$docs/site" | cut -f 1) MB"
[ ! -d solutions ] || echo "  Do not publish it: it lists and runs the reference. docs/instructors.md names what to publish."
