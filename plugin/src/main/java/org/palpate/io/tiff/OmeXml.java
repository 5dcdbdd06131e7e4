package org.palpate.io.tiff;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.palpate.io.file.NumberParser;

/**
 * The description that OME-TIFF files hold: sizes, the order of the pages and the spacing of the
 * first image.
 *
 * <p>Source: OME-TIFF specification and OME schema 2016-06, docs.openmicroscopy.org/ome-model.
 */
final class OmeXml {
  private static final long MAX_PLANES = 1 << 20;
  private static final Map<String, Double> MM_PER_UNIT =
      Map.ofEntries(
          Map.entry("m", 1e3),
          Map.entry("dm", 1e2),
          Map.entry("cm", 10.0),
          Map.entry("mm", 1.0),
          Map.entry("\u00b5m", 1e-3),
          Map.entry("\u03bcm", 1e-3),
          Map.entry("nm", 1e-6),
          Map.entry("pm", 1e-9),
          Map.entry("\u00c5", 1e-7),
          Map.entry("in", 25.4));

  private final Set<String> fileNames = new TreeSet<>();
  private final List<int[]> blocks = new ArrayList<>(); // first page (-1 none), z, c, t, count
  private final double[] spacingMm = {Double.NaN, Double.NaN, Double.NaN};
  private String order = "XYZCT";
  private int sizeZ = 1;
  private int sizeC = 1;
  private int sizeT = 1;
  private int samplesPerPixel = 1;
  private int images;

  private OmeXml() {}

  /** Returns the description that a text holds; empty if it is no OME-XML or is damaged. */
  static Optional<OmeXml> of(String text) {
    if (!text.contains("<OME") && !text.contains(":OME ")) {
      return Optional.empty();
    }
    OmeXml ome = new OmeXml();
    try {
      ome.parse(text.substring(text.indexOf('<'), text.lastIndexOf('>') + 1));
    } catch (XMLStreamException e) {
      return Optional.empty();
    }
    return ome.isUsable() ? Optional.of(ome) : Optional.empty();
  }

  private boolean isUsable() {
    return images > 0
        && sizeZ > 0
        && sizeC > 0
        && sizeT > 0
        && (double) sizeZ * sizeC * sizeT <= MAX_PLANES
        && order.matches("XY[ZCT]{3}");
  }

  private void parse(String text) throws XMLStreamException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    XMLStreamReader xml = factory.createXMLStreamReader(new StringReader(text));
    while (xml.hasNext()) {
      int event = xml.next();
      if (event == XMLStreamReader.START_ELEMENT) {
        images += xml.getLocalName().equals("Image") ? 1 : 0;
        if (images == 1) {
          startElement(xml);
        }
      }
    }
  }

  private void startElement(XMLStreamReader xml) {
    switch (xml.getLocalName()) {
      case "Pixels" -> readPixels(xml);
      case "Channel" -> samplesPerPixel = Math.max(1, number(xml, "SamplesPerPixel", 1));
      case "TiffData" ->
          blocks.add(
              new int[] {
                number(xml, "IFD", -1),
                number(xml, "FirstZ", 0),
                number(xml, "FirstC", 0),
                number(xml, "FirstT", 0),
                number(xml, "PlaneCount", -1)
              });
      case "UUID" ->
          Optional.ofNullable(xml.getAttributeValue(null, "FileName")).ifPresent(fileNames::add);
      default -> {}
    }
  }

  private void readPixels(XMLStreamReader xml) {
    order = Optional.ofNullable(xml.getAttributeValue(null, "DimensionOrder")).orElse(order);
    sizeZ = number(xml, "SizeZ", 1);
    sizeC = number(xml, "SizeC", 1);
    sizeT = number(xml, "SizeT", 1);
    for (int axis = 0; axis < 3; axis++) {
      String name = "PhysicalSize" + "XYZ".charAt(axis);
      String unit =
          Optional.ofNullable(xml.getAttributeValue(null, name + "Unit")).orElse("\u00b5m");
      String size = Optional.ofNullable(xml.getAttributeValue(null, name)).orElse("");
      double mm = NumberParser.number(size) * MM_PER_UNIT.getOrDefault(unit, Double.NaN);
      spacingMm[axis] = mm > 0 && !Double.isInfinite(mm) ? mm : Double.NaN;
    }
  }

  private static int number(XMLStreamReader xml, String attribute, int fallback) {
    String text = xml.getAttributeValue(null, attribute);
    return text == null ? fallback : NumberParser.positiveInt(text);
  }

  /** Returns the number of images in the file, of which the first is described. */
  int images() {
    return images;
  }

  /** Returns the names of the files that hold the pages, if the description states any. */
  Set<String> fileNames() {
    return fileNames;
  }

  /** Returns the spacing along an axis, 0 to 2, mm; NaN if it is not stated. */
  double spacingMm(int axis) {
    return spacingMm[axis];
  }

  /**
   * Returns the page of each plane.
   *
   * @param pageCount the pages of the file
   */
  PlaneTable planes(int pageCount) {
    int channels = Math.max(1, sizeC / samplesPerPixel);
    PlaneTable table = new PlaneTable(sizeZ, channels, sizeT);
    List<int[]> all = blocks.isEmpty() ? List.of(new int[] {-1, 0, 0, 0, -1}) : blocks;
    for (int[] block : all) {
      place(block, pageCount, table);
    }
    return table;
  }

  /** Assigns consecutive pages to consecutive planes in the stated order. */
  private void place(int[] block, int pageCount, PlaneTable dest) {
    int first = Math.max(0, block[0]);
    int count = block[4] >= 0 ? block[4] : block[0] >= 0 ? 1 : pageCount;
    int[] start = {block[1], block[2], block[3]};
    int[] sizes = {dest.slices(), dest.channels(), dest.times()};
    int position = 0;
    int weight = 1;
    int[] axes = new int[3];
    for (int n = 0; n < 3; n++) {
      axes[n] = "ZCT".indexOf(order.charAt(n + 2));
      position += Math.min(start[axes[n]], sizes[axes[n]]) * weight;
      weight *= sizes[axes[n]];
    }
    for (int n = 0; n < count && position + n < weight && first + n < pageCount; n++) {
      int rest = position + n;
      int[] at = new int[3];
      for (int axis : axes) {
        at[axis] = rest % sizes[axis];
        rest /= sizes[axis];
      }
      dest.setPage(at[0], at[1], at[2], first + n);
    }
  }
}
