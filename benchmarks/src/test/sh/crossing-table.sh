#!/bin/sh
# Measures by JMH what calls of hidapi from Java cost: by Palpate, by JNA and by hid4java, all with
# the same substitute library.
#
#   benchmarks/src/test/sh/crossing-table.sh [ROUNDS [JAVA_HOME ...]]
#
# In each of 5 rounds, each JDK measures each of these in a fresh process, so that other work of the
# machine affects all of them alike. The table has the processor time of the measuring thread,
# nanoseconds for each frame: the median, the least and the largest of the rounds. It also has the
# ratio to two empty native calls in the same process. It needs the build of ./palpate test.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../../.." && pwd -P)
substitutes=$root/native/target/cmake-tests/substitutes
classes=$root/benchmarks/target
rounds=${1:-5}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- "${JAVA_HOME:-/usr}"
[ -f "$substitutes/libhidapi-hidraw.so.0" ] && [ -d "$classes/test-classes" ] || {
  echo "palpate: not built yet: $root: run ./palpate test once" >&2
  exit 1
}
ln -sf libhidapi-hidraw.so.0 "$substitutes/libhidapi-hidraw.so"
ln -sf libhidapi-hidraw.so.0 "$substitutes/libhidapi.so"
(cd "$root" && mvn -q -B -o -pl core,native,plugin,benchmarks test-compile \
  -Dpalpate.skipCpp=true org.apache.maven.plugins:maven-dependency-plugin:3.6.1:build-classpath \
  -Dmdep.outputFile=target/test-classpath -Dmdep.includeScope=test) >&2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# Runs a fresh process for each kind of call, and appends lines of JDK, round, kind, nanoseconds.
measure() {
  jdk=$("$2/bin/java" -version 2>&1 | sed -n 's/.*version "\([0-9]*\).*/\1/p')
  PALPATE_NULL_HID=1 PALPATE_FAKE_HID=/nonexistent LD_LIBRARY_PATH=$substitutes \
    "$2/bin/java" -Djna.library.path="$substitutes" \
    -cp "$classes/test-classes:$classes/classes:$(cat "$classes/test-classpath")" \
    org.openjdk.jmh.Main HidPeersBenchmark -f 1 -wi 5 -w 300ms -i 5 -r 200ms \
    -prof org.palpate.benchmarks.speed.WorkerTime -rf csv -rff "$work/one.csv" \
    -jvmArgsAppend "-Djna.library.path=$substitutes" >"$work/log" 2>&1 || {
    tail -n 20 "$work/log" >&2
    exit 1
  }
  awk -F, -v jdk="$jdk" -v round="$1" '/:worker.cpu/ {
    gsub(/"/, ""); split($1, name, ":"); way = name[1]; sub(/.*[.]/, "", way)
    print jdk, round, way, $5
  }' "$work/one.csv" >>"$work/all"
}

round=0
while [ "$round" -lt "$rounds" ]; do
  round=$((round + 1))
  for home in "$@"; do measure "$round" "$home"; done
done

sort -k1,1n -k3,3 -k4,4n "$work/all" | awk '
  $3 == "twoEmptyCalls" { empty[$1 " " $2] = $4 }
  { key = $1 " " $3; if (!(key in count)) order[++keys] = key
    value[key, ++count[key]] = $4; from[key, count[key]] = $1 " " $2 }
  END {
    printf "%-4s %-14s %8s %8s %8s   %s\n", "JDK", "way", "median", "least", "most",
      "times two empty calls"
    for (k = 1; k <= keys; k++) {
      key = order[k]; n = count[key]; split(key, part, " "); low = 1e9; high = 0
      for (i = 1; i <= n; i++) {
        ratio = value[key, i] / empty[from[key, i]]
        if (ratio < low) low = ratio
        if (ratio > high) high = ratio
      }
      printf "%-4s %-14s %8.1f %8.1f %8.1f   %.1f to %.1f\n", part[1], part[2],
        value[key, int((n + 1) / 2)], value[key, 1], value[key, n], low, high
    }
  }'
