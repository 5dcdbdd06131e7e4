package org.palpate.io.dicom;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Separates the frames of a series that share their positions into steps, which differ in time,
 * echo or another attribute, and stacks of other directions. Selects one step.
 */
final class DicomSteps {
  /**
   * Directions that differ by more belong to different stacks; others are a fault of the series.
   */
  private static final double OTHER_DIRECTION = 1e-2;

  private static final int MAX_LISTED = 4;

  private final List<DicomFrame> frames;
  private final String place;
  private final ReadOptions options;
  private final List<String> notes;

  private DicomSteps(
      List<DicomFrame> frames, String place, ReadOptions options, List<String> notes) {
    this.frames = frames;
    this.place = place;
    this.options = options;
    this.notes = notes;
  }

  /** A step: its frames, and its values of the attributes that differ. */
  private record Step(List<DicomFrame> frames, List<String> values) {}

  /** The steps of a stack, and the attributes in which they differ. */
  private record Stack(List<Step> steps, List<StepAttribute> differences) {}

  /**
   * Returns the frames of one step. A note reports the choice.
   *
   * @throws VolumeFormatException if there are several steps and none is chosen, or if frames with
   *     one position cannot be told apart
   */
  static List<DicomFrame> select(
      List<DicomFrame> frames, String place, ReadOptions options, List<String> notes)
      throws VolumeFormatException {
    return new DicomSteps(frames, place, options, notes).select();
  }

  private List<DicomFrame> select() throws VolumeFormatException {
    if (frames.stream().anyMatch(frame -> frame.plane().isEmpty())) {
      ReadOptionChecks.chosenStep(1, options, Path.of(place), notes);
      return frames;
    }
    List<Stack> stacks = new ArrayList<>();
    for (List<DicomFrame> stack : stacks()) {
      stacks.add(separated(PositionGroups.of(stack)));
    }
    List<Step> steps = stacks.stream().flatMap(stack -> stack.steps().stream()).toList();
    int chosen =
        ReadOptionChecks.chosenStep(
            steps.size(), description(stacks), options, Path.of(place), notes);
    Step step = steps.get(chosen);
    for (Stack stack : stacks) {
      if (stack.steps().contains(step)) {
        requireWhole(step, chosen, stack);
      }
    }
    return step.frames();
  }

  private void requireWhole(Step step, int chosen, Stack stack) throws VolumeFormatException {
    int most = stack.steps().stream().mapToInt(other -> other.frames().size()).max().orElse(0);
    if (step.frames().size() < most) {
      throw new VolumeFormatException(
          "step " + chosen + " has " + step.frames().size() + " of " + most + " slices",
          place,
          "choose another step with --time, or export the whole series");
    }
  }

  /** Groups frames by their stack and by directions that differ clearly. */
  private List<List<DicomFrame>> stacks() {
    List<List<DicomFrame>> stacks = new ArrayList<>();
    for (DicomFrame frame : frames) {
      Optional<List<DicomFrame>> known =
          stacks.stream().filter(stack -> isSameStack(stack.get(0), frame)).findFirst();
      if (known.isPresent()) {
        known.get().add(frame);
      } else {
        stacks.add(new ArrayList<>(List.of(frame)));
      }
    }
    return stacks;
  }

  private static boolean isSameStack(DicomFrame a, DicomFrame b) {
    ImagePlane first = a.plane().orElseThrow();
    ImagePlane other = b.plane().orElseThrow();
    return StepAttribute.STACK.of(a).equals(StepAttribute.STACK.of(b))
        && first.directionDifference(other) <= OTHER_DIRECTION;
  }

  private Stack separated(PositionGroups groups) throws VolumeFormatException {
    if (groups.largest() == 1) {
      return new Stack(List.of(new Step(groups.frames(), List.of())), List.of());
    }
    for (List<StepAttribute> differences : StepAttribute.combinations()) {
      List<Step> steps = steps(groups, differences);
      if (!steps.isEmpty()) {
        return new Stack(steps, differences);
      }
    }
    if (groups.smallest() < groups.largest()) {
      throw samePositions(groups);
    }
    return new Stack(stepsByNumber(groups), List.of());
  }

  /** Returns the steps that some attributes separate; empty if they do not. */
  private static List<Step> steps(PositionGroups groups, List<StepAttribute> differences) {
    Set<List<String>> values = new TreeSet<>(StepAttribute::compare);
    for (List<DicomFrame> group : groups.groups()) {
      Set<List<String>> own = new TreeSet<>(StepAttribute::compare);
      group.forEach(frame -> own.add(StepAttribute.values(frame, differences)));
      if (own.size() < group.size()) {
        return List.of();
      }
      values.addAll(own);
    }
    if (values.size() != groups.largest()) {
      return List.of();
    }
    List<Step> steps = new ArrayList<>();
    for (List<String> value : values) {
      List<DicomFrame> found =
          groups.frames().stream()
              .filter(frame -> StepAttribute.values(frame, differences).equals(value))
              .toList();
      steps.add(new Step(found, value));
    }
    return steps;
  }

  /** Returns steps by the order of the numbers of the images at each position. */
  private static List<Step> stepsByNumber(PositionGroups groups) {
    List<Step> steps = new ArrayList<>();
    for (int n = 0; n < groups.largest(); n++) {
      List<DicomFrame> step = new ArrayList<>();
      for (List<DicomFrame> group : groups.groups()) {
        List<DicomFrame> inOrder = new ArrayList<>(group);
        inOrder.sort(Comparator.comparingInt(DicomSteps::instanceNumber));
        step.add(inOrder.get(n));
      }
      steps.add(new Step(step, List.of()));
    }
    return steps;
  }

  private static int instanceNumber(DicomFrame frame) {
    String number = frame.dicom().attributes().text(DicomTag.INSTANCE_NUMBER);
    return NumberParser.positiveInt(number) + frame.index();
  }

  private VolumeFormatException samePositions(PositionGroups groups) {
    List<List<DicomFrame>> doubles =
        groups.groups().stream().filter(group -> group.size() > 1).toList();
    StringBuilder text = new StringBuilder();
    for (List<DicomFrame> group : doubles.subList(0, Math.min(MAX_LISTED, doubles.size()))) {
      text.append(text.isEmpty() ? "" : " and ")
          .append(groups.position(group))
          .append(" (")
          .append(fileNames(group))
          .append(')');
    }
    return new VolumeFormatException(
        "several slices have the same position but other pixels, at "
            + text
            + (doubles.size() > MAX_LISTED ? " and more" : ""),
        place,
        "keep one of them each, or export each reconstruction as a series of its own");
  }

  private static String fileNames(List<DicomFrame> group) {
    List<String> names =
        group.stream()
            .map(frame -> frame.dicom().file().getFileName().toString())
            .distinct()
            .toList();
    return names.size() == 1 ? "frames of " + names.get(0) : String.join(", ", names);
  }

  private static String description(List<Stack> stacks) {
    if (stacks.size() == 1) {
      return description(stacks.get(0));
    }
    List<String> parts = new ArrayList<>();
    for (int n = 0; n < Math.min(stacks.size(), MAX_LISTED); n++) {
      parts.add(description(stacks.get(n)));
    }
    return stacks.size()
        + " stacks: "
        + String.join("; ", parts)
        + (stacks.size() > MAX_LISTED ? "; and more" : "");
  }

  private static String description(Stack stack) {
    List<Step> steps = stack.steps();
    int slices = steps.get(0).frames().size();
    String each = slices + (slices == 1 ? " slice" : " slices");
    if (steps.size() == 1) {
      return each;
    }
    if (stack.differences().isEmpty()) {
      return steps.size() + " images at each position, told apart by their numbers alone";
    }
    List<String> differences = new ArrayList<>();
    for (int n = 0; n < stack.differences().size(); n++) {
      int which = n;
      Set<String> values = new TreeSet<>(StepAttribute::compareValues);
      steps.forEach(step -> values.add(step.values().get(which)));
      differences.add(stack.differences().get(n).description(values));
    }
    return String.join(" x ", differences) + ", each of " + each;
  }
}
