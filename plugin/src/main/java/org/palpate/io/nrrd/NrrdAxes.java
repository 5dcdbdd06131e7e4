package org.palpate.io.nrrd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.Grids;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.VoxelGrid;

/**
 * The meaning of the axes of a NRRD.
 *
 * @param grid the three spatial axes
 * @param extra the non-spatial axis; one of its steps is chosen, unless they are colours or layers
 * @param extraKind the meaning of the non-spatial axis
 * @param coordinateSystem directions of the world axes in the patient
 * @param sampleCount samples over all axes
 * @param notes assumptions that the user should know
 */
record NrrdAxes(
    VoxelGrid grid,
    NonSpatialAxis extra,
    ExtraKind extraKind,
    CoordinateSystem coordinateSystem,
    long sampleCount,
    List<String> notes) {
  private static final int MAX_AXES = 16;
  private static final Set<String> SPACE_KINDS = Set.of("domain", "space", "???", "none");
  private static final Set<String> MANY_NUMBERS =
      Set.of(
          "vector",
          "covariant-vector",
          "normal",
          "point",
          "complex",
          "2-vector",
          "3-vector",
          "3-gradient",
          "3-normal",
          "4-vector",
          "quaternion");
  private static final Pattern VECTOR = Pattern.compile("\\(([^()]*)\\)|(none)");
  private static final Pattern QUOTED = Pattern.compile("\"([^\"]*)\"");

  /** The meanings of a non-spatial axis. */
  enum ExtraKind {
    /** No such axis, or an axis of time or components, of which one step is read. */
    STEPS,
    /** Red, green, blue and perhaps opacity. */
    COLOUR,
    /** Labels that may overlap. */
    LAYERS
  }

  /** Interprets the axes of a header. */
  static NrrdAxes of(NrrdHeader header, ReadOptions options) throws VolumeFormatException {
    return new Reading(header, options).read();
  }

  /** Holds the state while one header is interpreted. */
  private static final class Reading {
    private final NrrdHeader header;
    private final ReadOptions options;
    private final List<String> notes = new ArrayList<>();
    private ExtraKind extraKind = ExtraKind.STEPS;
    private int[] sizes;
    private Vec3[] directions; // null for a non-spatial axis, or if the header has none

    Reading(NrrdHeader header, ReadOptions options) {
      this.header = header;
      this.options = options;
    }

    NrrdAxes read() throws VolumeFormatException {
      int dimension = NumberParser.positiveInt(header.required("dimension"));
      if (dimension < 1 || dimension > MAX_AXES) {
        throw header.refusal("the dimension is '" + header.required("dimension") + "'");
      }
      sizes = sizes(dimension);
      long samples = sampleCount();
      directions = directions(dimension);
      List<Integer> space = spaceAxes(dimension);
      NonSpatialAxis extra = extraAxis(space);
      VoxelGrid grid = grid(space);
      return new NrrdAxes(grid, extra, extraKind, coordinateSystem(), samples, notes);
    }

    private int[] sizes(int dimension) throws VolumeFormatException {
      header.required("sizes");
      String[] words = header.words("sizes");
      if (words.length != dimension) {
        throw header.refusal(
            "the dimension is " + dimension + " but there are " + words.length + " sizes");
      }
      int[] result = new int[dimension];
      for (int axis = 0; axis < dimension; axis++) {
        result[axis] = NumberParser.positiveInt(words[axis]);
        if (result[axis] < 1) {
          throw header.refusal("the size along axis " + axis + " is '" + words[axis] + "'");
        }
      }
      return result;
    }

    private long sampleCount() throws VolumeFormatException {
      try {
        long count = 8; // the bytes of the largest type must be countable too
        for (int size : sizes) {
          count = Math.multiplyExact(count, (long) size);
        }
        return count / 8;
      } catch (ArithmeticException e) {
        throw header.refusal("the sizes make more than 2^60 voxels");
      }
    }

    private Vec3[] directions(int dimension) throws VolumeFormatException {
      if (header.field("space directions").isEmpty()) {
        return null;
      }
      Matcher matcher = VECTOR.matcher(header.required("space directions"));
      Vec3[] result = new Vec3[dimension];
      int found = 0;
      for (; matcher.find(); found++) {
        if (found < dimension && matcher.group(2) == null) {
          result[found] = vector(matcher.group(1));
        }
      }
      if (found != dimension) {
        throw header.refusal(
            "the dimension is " + dimension + " but there are " + found + " space directions");
      }
      return result;
    }

    private Vec3 vector(String text) throws VolumeFormatException {
      String[] words = text.split(",", -1);
      if (words.length != 3) {
        throw header.refusal("the vector (" + text + ") has " + words.length + " numbers, not 3");
      }
      return new Vec3(
          NumberParser.number(words[0]),
          NumberParser.number(words[1]),
          NumberParser.number(words[2]));
    }

    private List<Integer> spaceAxes(int dimension) throws VolumeFormatException {
      String[] kinds = header.words("kinds");
      List<Integer> space = new ArrayList<>();
      for (int axis = 0; axis < dimension; axis++) {
        String kind = axis < kinds.length ? kinds[axis].toLowerCase(Locale.ROOT) : "???";
        if (directions != null ? directions[axis] != null : SPACE_KINDS.contains(kind)) {
          space.add(axis);
        }
      }
      while (directions == null && space.size() > 3) {
        space.remove(space.size() - 1);
      }
      if (space.size() < 2 || space.size() > 3) {
        throw new VolumeFormatException(
            "the file has " + space.size() + " spatial axes",
            header.file(),
            "give a volume with three spatial axes (kinds: domain domain domain)");
      }
      return space;
    }

    private NonSpatialAxis extraAxis(List<Integer> space) throws VolumeFormatException {
      NonSpatialAxis extra = NonSpatialAxis.NONE;
      String kind = "";
      for (int axis = 0; axis < sizes.length; axis++) {
        int here = axis;
        if (!space.contains(axis) && sizes[axis] > 1) {
          if (extra.count() > 1) {
            throw header.refusal("the file has more than one non-spatial axis");
          }
          int position = (int) space.stream().filter(other -> other < here).count();
          // two spatial axes are followed by an implied third one of one voxel
          int place = position == space.size() ? 3 : position;
          extra = new NonSpatialAxis(place, sizes[axis], 0);
          kind = kind(axis);
        }
      }
      extraKind = extraKind(kind, extra);
      if (extraKind != ExtraKind.STEPS) {
        return extra;
      }
      int step =
          ReadOptionChecks.chosenStep(
              extra.count(), steps(kind, extra.count()), options, header.file(), notes);
      return new NonSpatialAxis(extra.position(), extra.count(), step);
    }

    private static String steps(String kind, int count) {
      return switch (kind) {
        case "time" -> count + " times";
        case "list" -> "a list of " + count + " volumes";
        default -> count + " time steps or components";
      };
    }

    private String kind(int axis) {
      String[] kinds = header.words("kinds");
      return axis < kinds.length ? kinds[axis].toLowerCase(Locale.ROOT) : "";
    }

    /**
     * Returns the meaning of the non-spatial axis.
     *
     * @throws VolumeFormatException if its numbers are no values of their own, and none is chosen
     */
    private ExtraKind extraKind(String kind, NonSpatialAxis extra) throws VolumeFormatException {
      if (options.timeStep().isPresent() || extra.count() == 1) {
        return ExtraKind.STEPS;
      }
      if (kind.equals("list") && hasSeveralLayers()) {
        return ExtraKind.LAYERS;
      }
      boolean rgb = kind.matches("rgba?-color|[34]-color");
      if (rgb && extra.position() == 0 && extra.count() == (kind.matches("rgba.*|4.*") ? 4 : 3)) {
        return ExtraKind.COLOUR;
      }
      if (kind.endsWith("-color")) {
        throw noScan("the voxels are colours of " + extra.count() + " numbers", kind, extra);
      }
      if (MANY_NUMBERS.contains(kind) || kind.contains("matrix")) {
        throw noScan("the voxels are vectors of " + extra.count() + " numbers", kind, extra);
      }
      return ExtraKind.STEPS;
    }

    private boolean hasSeveralLayers() {
      return SlicerSegments.of(header).segments().stream().anyMatch(s -> s.layer() > 0);
    }

    private VolumeFormatException noScan(String what, String kind, NonSpatialAxis extra) {
      return new VolumeFormatException(
          what + " (kind " + kind + "), not the values of a scan",
          header.file(),
          "choose one of the numbers with --time 0 to --time " + (extra.count() - 1));
    }

    private VoxelGrid grid(List<Integer> space) throws VolumeFormatException {
      int[] three = {1, 1, 1};
      Vec3[] steps = Grids.steps(new Vec3(1, 1, 1));
      Vec3 centre = new Vec3();
      for (int n = 0; n < space.size(); n++) {
        three[n] = sizes[space.get(n)];
        steps[n] = step(n, space.get(n), centre);
      }
      if (space.size() == 2) {
        notes.add("a single slice: the slice spacing is taken to be the pixel spacing");
        steps[2] = thickness(steps[0], steps[1]);
      }
      if (header.field("space origin").isPresent()) {
        Matcher matcher = VECTOR.matcher(header.required("space origin"));
        centre = vector(matcher.matches() && matcher.group(1) != null ? matcher.group(1) : "");
      }
      scale(steps, centre, space.get(0));
      return Grids.of(three, steps, centre, header.file());
    }

    /** Returns a step perpendicular to two others, as long as the first. */
    private Vec3 thickness(Vec3 a, Vec3 b) {
      Vec3 normal = a.cross(b, new Vec3());
      return normal.mul(a.length() / normal.length(), normal);
    }

    /**
     * Returns the step along the n-th spatial axis, and sets in {@code centre} where voxel 0 is
     * along it.
     */
    private Vec3 step(int n, int axis, Vec3 centre) throws VolumeFormatException {
      if (directions != null) {
        return directions[axis];
      }
      Vec3 step = new Vec3();
      double low = perAxis("axis mins", axis);
      double high = perAxis("axis maxs", axis);
      boolean node = isNode(axis);
      int intervals = node ? sizes[axis] - 1 : sizes[axis];
      double spacing = perAxis("spacings", axis);
      if (Double.isNaN(spacing) && header.field("spacings").isPresent()) {
        throw header.refusal("the spacing along axis " + axis + " is no number");
      }
      if (Double.isNaN(spacing)) {
        spacing = (high - low) / intervals;
      }
      if (Double.isNaN(spacing)) {
        spacing = 1;
        notes.add("no spacing along " + "xyz".charAt(n) + ": 1 mm assumed");
      }
      if (!Double.isNaN(low)) {
        centre.set(n, node ? low : low + spacing / 2);
      }
      if (spacing < 0) {
        notes.add(Grids.negativeSpacing(n, spacing, Grids.RUNS_BACKWARD));
      }
      step.set(n, spacing);
      return step;
    }

    private boolean isNode(int axis) {
      String[] words = header.words("centerings");
      return axis < words.length && words[axis].equalsIgnoreCase("node");
    }

    private double perAxis(String field, int axis) {
      String[] words = header.words(field);
      return axis < words.length ? NumberParser.number(words[axis]) : Double.NaN;
    }

    /** Converts steps and centre from the header's unit to millimetres. */
    private void scale(Vec3[] steps, Vec3 centre, int firstAxis) throws VolumeFormatException {
      boolean ofSpace = header.field("space units").isPresent();
      Matcher matcher =
          QUOTED.matcher(header.fields().getOrDefault(ofSpace ? "space units" : "units", ""));
      String unit = "";
      for (int axis = 0; matcher.find() && axis <= (ofSpace ? 0 : firstAxis); axis++) {
        unit = matcher.group(1).strip();
      }
      double mm = mmPerUnit(unit);
      for (Vec3 step : steps) {
        step.mul(mm, step);
      }
      centre.mul(mm, centre);
    }

    private double mmPerUnit(String unit) throws VolumeFormatException {
      return switch (unit) {
        case "", "???", "mm", "millimeter", "millimeters", "millimetre" -> 1;
        case "cm" -> 10;
        case "m", "meter", "metre" -> 1000;
        case "um", "\u00b5m", "\u03bcm", "micron", "microns", "micrometer" -> 1e-3;
        case "nm" -> 1e-6;
        default -> throw header.refusal("the unit of length '" + unit + "' is unknown");
      };
    }

    private CoordinateSystem coordinateSystem() throws VolumeFormatException {
      String space = header.fields().getOrDefault("space", "").toLowerCase(Locale.ROOT);
      return switch (space) {
        case "left-posterior-superior", "lps" -> CoordinateSystem.LPS;
        case "right-anterior-superior", "ras" -> CoordinateSystem.RAS;
        case "left-anterior-superior", "las" -> CoordinateSystem.LAS;
        case "", "scanner-xyz", "3d-right-handed", "3d-left-handed" -> CoordinateSystem.UNKNOWN;
        default ->
            throw header.refusal("the space '" + space + "' is unknown or has not three axes");
      };
    }
  }
}
