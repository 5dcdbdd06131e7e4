package org.palpate.io.dicom;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.palpate.io.file.NumberParser;

/**
 * An attribute in which frames with the same position may differ.
 *
 * <p>Source: DICOM PS3.3, C.7.6.16.2 and the modules of MR and CT.
 */
enum StepAttribute {
  TEMPORAL_INDEX("time", "times", "", DicomTag.FRAME_CONTENT_SEQUENCE, DicomTag.TEMPORAL_INDEX),
  TEMPORAL_POSITION("time", "times", "", 0, DicomTag.TEMPORAL_POSITION),
  TRIGGER_TIME("time", "times", " ms", 0, DicomTag.TRIGGER_TIME),
  CARDIAC_DELAY("time", "times", " ms", DicomTag.CARDIAC_SEQUENCE, DicomTag.CARDIAC_DELAY),
  ECHO_TIME("echo", "echoes", " ms", 0, DicomTag.ECHO_TIME),
  EFFECTIVE_ECHO_TIME(
      "echo", "echoes", " ms", DicomTag.MR_ECHO_SEQUENCE, DicomTag.EFFECTIVE_ECHO_TIME),
  ECHO_NUMBER("echo", "echoes", "", 0, DicomTag.ECHO_NUMBER),
  DIFFUSION_B(
      "diffusion weight",
      "diffusion weights",
      " s/mm^2",
      DicomTag.MR_DIFFUSION_SEQUENCE,
      DicomTag.DIFFUSION_B),
  IMAGE_TYPE("kind of image", "kinds of image", "", 0, DicomTag.IMAGE_TYPE),
  KERNEL("reconstruction", "reconstructions", "", 0, DicomTag.KERNEL),
  ACQUISITION("acquisition", "acquisitions", "", 0, DicomTag.ACQUISITION_NUMBER),
  STACK("stack", "stacks", "", DicomTag.FRAME_CONTENT_SEQUENCE, DicomTag.STACK_ID);

  private static final int MAX_LISTED = 6;

  private final String one;
  private final String many;
  private final String unit;
  private final int sequence;
  private final int tag;

  StepAttribute(String one, String many, String unit, int sequence, int tag) {
    this.one = one;
    this.many = many;
    this.unit = unit;
    this.sequence = sequence;
    this.tag = tag;
  }

  /** Returns the value for a frame; empty if the file does not have it. */
  String of(DicomFrame frame) {
    return frame.attributes().text(sequence, tag);
  }

  /** Returns the values of some attributes for a frame. */
  static List<String> values(DicomFrame frame, List<StepAttribute> attributes) {
    return attributes.stream().map(attribute -> attribute.of(frame)).toList();
  }

  /** Returns the attributes that may separate frames: each alone, then each pair. */
  static List<List<StepAttribute>> combinations() {
    List<List<StepAttribute>> all = new ArrayList<>();
    List<StepAttribute> each = new ArrayList<>(List.of(values()));
    each.remove(STACK);
    each.forEach(attribute -> all.add(List.of(attribute)));
    for (int a = 0; a < each.size(); a++) {
      for (int b = a + 1; b < each.size(); b++) {
        all.add(List.of(each.get(a), each.get(b)));
      }
    }
    return all;
  }

  /** Compares lists of values of the same attributes. */
  static int compare(List<String> a, List<String> b) {
    for (int n = 0; n < a.size(); n++) {
      int order = compareValues(a.get(n), b.get(n));
      if (order != 0) {
        return order;
      }
    }
    return 0;
  }

  /** Compares two values, as numbers if both are. */
  static int compareValues(String a, String b) {
    double first = NumberParser.number(a);
    double second = NumberParser.number(b);
    boolean numbers = Double.isFinite(first) && Double.isFinite(second);
    int order = numbers ? Double.compare(first, second) : 0;
    return order != 0 ? order : a.compareTo(b);
  }

  /** Returns "3 times (0, 100, 200 ms)": how many values there are, and those that are numbers. */
  String description(Collection<String> values) {
    String text = values.size() + " " + (values.size() == 1 ? one : many);
    boolean numbers =
        values.stream().allMatch(value -> Double.isFinite(NumberParser.number(value)));
    if (!numbers || values.size() > MAX_LISTED) {
      return text;
    }
    return text + " (" + String.join(", ", values) + unit + ")";
  }
}
