package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.OptionalInt;

/**
 * Which processors this process may run on and which of them the kernel keeps free of other work.
 *
 * @param allowed where this process may run
 * @param isolated kept out of the scheduler's balancing ({@code isolcpus})
 * @param tickless run without a periodic tick while one thread runs ({@code nohz_full})
 */
record CpuTopology(BitSet allowed, BitSet isolated, BitSet tickless) {

  /**
   * Reads the kernel's files under {@code root}; what is not there counts as an empty set.
   *
   * @param root {@code /}, or a tree of the same shape
   */
  static CpuTopology read(Path root) {
    BitSet allowed = new BitSet();
    KernelFiles.field(root.resolve("proc/self/status"), "Cpus_allowed_list")
        .map(CpuList::parse)
        .ifPresent(allowed::or);
    return new CpuTopology(
        allowed,
        cpus(root.resolve("sys/devices/system/cpu/isolated")),
        cpus(root.resolve("sys/devices/system/cpu/nohz_full")));
  }

  private static BitSet cpus(Path file) {
    return KernelFiles.line(file).map(CpuList::parse).orElseGet(BitSet::new);
  }

  /**
   * The processor for one more thread that keeps a processor to itself: an isolated one first, then
   * a tickless one, else the highest, since interrupts gather on the lowest.
   *
   * @param taken already given to such threads
   * @return empty where nothing would be left for the rest of the machine
   */
  OptionalInt choose(BitSet taken) {
    BitSet free = minus(allowed, taken);
    if (free.cardinality() < 2 && !isolated.intersects(free)) {
      return OptionalInt.empty();
    }
    for (BitSet preferred : new BitSet[] {isolated, tickless}) {
      BitSet both = (BitSet) free.clone();
      both.and(preferred);
      if (!both.isEmpty()) {
        return OptionalInt.of(both.length() - 1);
      }
    }
    return OptionalInt.of(free.length() - 1);
  }

  /** A processor's number, and what the kernel spares it. */
  String name(int cpu) {
    return cpu + (isolated.get(cpu) ? " isolated" : "") + (tickless.get(cpu) ? " nohz_full" : "");
  }

  private static BitSet minus(BitSet all, BitSet some) {
    BitSet rest = (BitSet) all.clone();
    rest.andNot(some);
    return rest;
  }
}
