package org.palpate.device.protocol;

import java.util.HashMap;
import java.util.Map;

/**
 * The part of a HID report descriptor that the protocol fixes: the usage of the outermost
 * collection, and the length of each report. Immutable.
 *
 * <p>Reference: Device Class Definition for HID 1.11, section 6.2.2.
 *
 * @param usagePage usage page of the first application collection; 0 if there is none
 * @param usage usage of that collection
 * @param bits number of bits of each report, the id left out
 */
record ReportDescriptor(int usagePage, int usage, Map<Key, Long> bits) {
  private static final int LONG_ITEM = 0xFE;
  private static final int APPLICATION = 1;

  /** The kinds of reports, with the prefix of their main item. */
  enum Kind {
    INPUT(0x80),
    OUTPUT(0x90),
    FEATURE(0xB0);

    private final int prefix;

    Kind(int prefix) {
      this.prefix = prefix;
    }
  }

  /** Names a report. */
  record Key(Kind kind, int id) {}

  /** Returns the length of a report without its id, bytes; 0 if there is none. */
  long bytes(Kind kind, int id) {
    return (bits.getOrDefault(new Key(kind, id), 0L) + 7) / 8;
  }

  /** Parses a descriptor. An item that is cut at the end is ignored. */
  static ReportDescriptor parse(Bytes descriptor) {
    Parser parser = new Parser();
    int at = 0;
    while (at < descriptor.length()) {
      int prefix = descriptor.unsigned8(at);
      int size =
          prefix == LONG_ITEM && at + 1 < descriptor.length() ? descriptor.unsigned8(at + 1) : -1;
      int length = size >= 0 ? size + 2 : (prefix & 3) == 3 ? 4 : prefix & 3;
      if (at + 1 + length <= descriptor.length() && size < 0) {
        parser.take(prefix & 0xFC, value(descriptor, at + 1, length));
      }
      at += 1 + length;
    }
    return new ReportDescriptor(parser.topPage, parser.topUsage, Map.copyOf(parser.bits));
  }

  private static long value(Bytes bytes, int from, int length) {
    long value = 0;
    for (int i = 0; i < length; i++) {
      value |= (long) bytes.unsigned8(from + i) << (8 * i);
    }
    return value;
  }

  /** The state while items are read. */
  private static final class Parser {
    final Map<Key, Long> bits = new HashMap<>();
    int topPage;
    int topUsage;
    private boolean inCollection;
    private int page;
    private int usage;
    private int id;
    private long size;
    private long count;

    void take(int item, long value) {
      switch (item) {
        case 0x04 -> page = (int) value;
        case 0x08 -> usage = (int) value;
        case 0x74 -> size = value;
        case 0x84 -> id = (int) value;
        case 0x94 -> count = value;
        case 0xA0 -> beginCollection((int) value);
        default -> addReport(item);
      }
    }

    private void beginCollection(int type) {
      if (!inCollection && type == APPLICATION) {
        topPage = page;
        topUsage = usage;
        inCollection = true;
      }
    }

    private void addReport(int item) {
      for (Kind kind : Kind.values()) {
        if (item == kind.prefix) {
          bits.merge(new Key(kind, id), size * count, Long::sum);
        }
      }
    }
  }
}
