package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.OptionalInt;

/**
 * The processors that this process may use, and those that the kernel keeps free of other work.
 *
 * @param allowed processors that this process may run on
 * @param isolated processors excluded from the scheduler's balancing ({@code isolcpus})
 * @param tickless processors without a periodic tick while one thread runs ({@code nohz_full})
 */
record CpuTopology(BitSet allowed, BitSet isolated, BitSet tickless) {

  /**
   * Reads the kernel's files; a missing file counts as an empty set.
   *
   * @param root {@code /}, or a folder with the same structure
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
   * Chooses the processor for one more thread that needs a processor of its own: an isolated one
   * first, then a tickless one, then the highest, because interrupts gather on the lowest.
   *
   * @param taken processors that such threads already have
   * @return empty if no processor would remain for everything else
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

  /** Returns the number of a processor and its special roles, such as {@code 3 isolated}. */
  String name(int cpu) {
    return cpu + (isolated.get(cpu) ? " isolated" : "") + (tickless.get(cpu) ? " nohz_full" : "");
  }

  private static BitSet minus(BitSet all, BitSet some) {
    BitSet rest = (BitSet) all.clone();
    rest.andNot(some);
    return rest;
  }
}
