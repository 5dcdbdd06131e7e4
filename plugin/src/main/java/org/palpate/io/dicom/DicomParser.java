package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.palpate.io.file.NumberText;

/**
 * Finds the attributes of {@link DicomTag} and the pixel data in a DICOM data set, and skips all
 * other attributes unread.
 *
 * <p>Source: DICOM PS3.5, sections 7 and A.
 */
final class DicomParser {
  private static final long UNDEFINED = 0xffffffffL;
  private static final int META_GROUP = 2;
  private static final int MAX_DEPTH = 16;
  private static final int MAX_VALUE_BYTES = 1024;
  private static final int MAX_LONG_VALUE_BYTES = 1 << 20;
  private static final int MAX_FRAGMENTS = 1 << 20;
  private static final Set<String> LONG_VRS =
      Set.of("OB", "OW", "OF", "OD", "OL", "OV", "SQ", "SV", "UC", "UN", "UR", "UT", "UV");

  private final DicomBytes bytes;
  private final ByteOrder order;
  private long at;
  private final List<PixelDataItem> pixelDataItems = new ArrayList<>();
  private boolean encapsulated;
  private boolean floating;
  private boolean words;

  /**
   * The position of pixel data in the file, in bytes.
   *
   * @param place offset of the first byte
   * @param length number of bytes
   */
  record PixelDataItem(long place, long length) {}

  /** Creates a parser at an offset. */
  DicomParser(DicomBytes bytes, long from, ByteOrder order) {
    this.bytes = bytes;
    this.order = order;
    at = from;
  }

  /** Parses up to an offset, or to the end of the pixel data. */
  void parse(long end, boolean explicit, DicomDataSet into) throws IOException {
    parse(end, explicit, into, 0);
  }

  /** Parses the attributes of group 2, which are explicit, and returns the offset after them. */
  long parseMeta(long end, DicomDataSet into) throws IOException {
    while (at < end && (bytes.at(at, 2, order).getShort(0) & 0xffff) == META_GROUP) {
      parseElement(tag(), end, true, into, 0);
    }
    return at;
  }

  /** Returns one item of native pixel data, or the fragments after the offset table. */
  List<PixelDataItem> pixelDataItems() {
    return pixelDataItems;
  }

  /** Whether the pixel data are encapsulated. */
  boolean isEncapsulated() {
    return encapsulated;
  }

  /** Whether native pixels are words of 16 bits, which the byte order swaps. */
  boolean areWords() {
    return words;
  }

  /** Whether pixels are floating-point numbers. */
  boolean isFloating() {
    return floating;
  }

  private void parse(long end, boolean explicit, DicomDataSet into, int depth) throws IOException {
    if (depth > MAX_DEPTH) {
      throw new IOException("too many nested sequences");
    }
    while (at < end && pixelDataItems.isEmpty()) {
      int tag = tag();
      if (tag == DicomTag.ITEM_END || tag == DicomTag.SEQUENCE_END) {
        at += 4;
        return;
      }
      parseElement(tag, end, explicit, into, depth);
    }
  }

  private void parseElement(int tag, long end, boolean explicit, DicomDataSet into, int depth)
      throws IOException {
    String vr = explicit && (tag >>> 16) != 0xFFFE ? vr() : "";
    long length = length(vr);
    if (length != UNDEFINED && length > end - at) {
      throw new IOException("an attribute is longer than its data set");
    }
    boolean sequence =
        vr.equals("SQ")
            || (vr.isEmpty() && DicomTag.SEQUENCES.contains(tag))
            || ((vr.isEmpty() || vr.equals("UN")) && length == UNDEFINED && tag != DicomTag.PIXELS);
    if (isPixels(tag) && depth == 0) {
      putPixelData(tag, vr, length, end);
    } else if (sequence) {
      parseSequence(tag, length, explicit && !vr.equals("UN"), into, depth);
    } else if (length == UNDEFINED) {
      skipFragments(end);
    } else {
      putValue(tag, vr, (int) Math.min(length, Integer.MAX_VALUE), into);
      at += length;
    }
  }

  private static boolean isPixels(int tag) {
    return tag == DicomTag.PIXELS || tag == DicomTag.FLOAT_PIXELS || tag == DicomTag.DOUBLE_PIXELS;
  }

  private void parseSequence(int tag, long length, boolean explicit, DicomDataSet into, int depth)
      throws IOException {
    boolean wanted = DicomTag.SEQUENCES.contains(tag);
    if (!wanted && length != UNDEFINED) {
      at += length;
      return;
    }
    long end = length == UNDEFINED ? bytes.length() : at + length;
    while (at < end) {
      int item = tag();
      long itemLength = bytes.at(at, 4, order).getInt() & UNDEFINED;
      at += 4;
      if (item == DicomTag.SEQUENCE_END) {
        return;
      }
      if (item != DicomTag.ITEM || (itemLength != UNDEFINED && itemLength > end - at)) {
        throw new IOException("a sequence has an invalid item");
      }
      DicomDataSet items = wanted ? into.addItem(tag) : new DicomDataSet();
      parse(itemLength == UNDEFINED ? end : at + itemLength, explicit, items, depth + 1);
    }
  }

  private void putValue(int tag, String vr, int length, DicomDataSet into) throws IOException {
    boolean number = DicomTag.NUMBERS.contains(tag);
    boolean real = DicomTag.DOUBLES.contains(tag);
    boolean isLong = tag == DicomTag.FRAME_OFFSETS;
    if ((!number && !real && !DicomTag.TEXTS.contains(tag))
        || length > (isLong ? MAX_LONG_VALUE_BYTES : MAX_VALUE_BYTES)) {
      return;
    }
    ByteBuffer value = bytes.at(at, length, order);
    if (number) {
      into.put(tag, numbers(tag, vr, value));
    } else if (real && length >= 8) {
      into.put(tag, NumberText.text(value.getDouble(0)).getBytes(StandardCharsets.ISO_8859_1));
    } else if (!real) {
      byte[] text = new byte[length];
      value.get(text);
      into.put(tag, text);
    }
  }

  private static int[] numbers(int tag, String vr, ByteBuffer value) {
    boolean wide = vr.equals("UL") || (vr.isEmpty() && tag == DicomTag.TEMPORAL_INDEX);
    int[] numbers = new int[value.remaining() / (wide ? 4 : 2)];
    for (int n = 0; n < numbers.length; n++) {
      numbers[n] = wide ? value.getInt(4 * n) : value.getShort(2 * n) & 0xffff;
    }
    return numbers;
  }

  private void putPixelData(int tag, String vr, long length, long end) throws IOException {
    floating = tag != DicomTag.PIXELS;
    words = vr.equals("OW");
    encapsulated = length == UNDEFINED;
    if (!encapsulated) {
      pixelDataItems.add(new PixelDataItem(at, length));
      at += length;
      return;
    }
    List<PixelDataItem> all = fragments(end);
    if (all.size() < 2) {
      throw new IOException("the compressed pixels have no fragment");
    }
    pixelDataItems.addAll(all.subList(1, all.size())); // the first is the offset table
  }

  private void skipFragments(long end) throws IOException {
    fragments(end);
  }

  private List<PixelDataItem> fragments(long end) throws IOException {
    List<PixelDataItem> found = new ArrayList<>();
    while (at < end) {
      int tag = tag();
      long length = bytes.at(at, 4, order).getInt() & UNDEFINED;
      at += 4;
      if (tag == DicomTag.SEQUENCE_END) {
        return found;
      }
      if (tag != DicomTag.ITEM || length > end - at || found.size() > MAX_FRAGMENTS) {
        throw new IOException("the compressed pixels are damaged");
      }
      found.add(new PixelDataItem(at, length));
      at += length;
    }
    throw new IOException("the compressed pixels have no end");
  }

  private int tag() throws IOException {
    ByteBuffer four = bytes.at(at, 4, order);
    at += 4;
    return (four.getShort(0) & 0xffff) << 16 | (four.getShort(2) & 0xffff);
  }

  private String vr() throws IOException {
    ByteBuffer two = bytes.at(at, 2, order);
    at += 2;
    String vr = "" + (char) (two.get(0) & 0xff) + (char) (two.get(1) & 0xff);
    if (!vr.matches("[A-Z]{2}")) {
      throw new IOException("an attribute has no value representation");
    }
    return vr;
  }

  /** Whether values of a representation have a length of four bytes. */
  static boolean isLong(String vr) {
    return LONG_VRS.contains(vr);
  }

  private long length(String vr) throws IOException {
    if (!vr.isEmpty() && !isLong(vr)) {
      int length = bytes.at(at, 2, order).getShort() & 0xffff;
      at += 2;
      return length;
    }
    at += vr.isEmpty() ? 0 : 2; // reserved
    long length = bytes.at(at, 4, order).getInt() & UNDEFINED;
    at += 4;
    return length;
  }
}
