package org.palpate.app.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.palpate.app.process.PalpateException;
import org.palpate.body.BodyScene;
import org.palpate.collision.CollisionDevice;
import org.palpate.force.FeelSettings;
import org.palpate.force.MassSettings;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ToolScene;
import org.palpate.io.file.NumberParser;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.scene.SceneTool;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.tool.RodShape;
import org.palpate.tool.MadeTool;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.tool.ToolSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;

/** The options that choose the tool and its clearance. */
public final class ToolOptions {
  private static final List<String> OF_POINTS =
      Stream.concat(
              Stream.of("--solver", "--collision", "--border", "--friction-form"),
              ElasticOptions.NAMES.stream())
          .toList();

  private static final List<String> OF_RIGID_TOOLS =
      List.of("--clearance", "--rotational-stiffness", "--legs-every", "--legs-frames");

  @Option(
      names = "--tool",
      paramLabel = "SPEC",
      description = {
        "The tool: point, sphere:R, capsule:R,L (L between the centres of its ends), cylinder:R,L,"
            + " box:A,B,C, needle:R,L (L without its round tip), a mesh (STL, OBJ, PLY in mm) or a"
            + " volume file. Lengths in mm; shapes are centred and lie along z. Default:"
            + " ${DEFAULT-VALUE}."
      },
      defaultValue = "point")
  private String tool;

  @Option(
      names = "--tool-segment",
      paramLabel = "NAME=SPEC",
      description =
          "The voxels of a tool from a volume file, as in --segment. Default: tool=nonzero.")
  private String segment;

  @Option(
      names = "--points",
      paramLabel = "N",
      description = {
        "Thins the tool to at most N points. Then only these points keep clear of solids, not the"
            + " whole tool."
      })
  private Integer points;

  @Option(
      names = "--clearance",
      paramLabel = "points|body|MM",
      description = {
        "Clearance of the tool: points (no point enters a solid), body (tool and solids do not"
            + " overlap), or a margin in mm between them. A negative margin lets them overlap by"
            + " that depth. Bodies that move keep it from each other, with --tool point too."
            + " Default: that of the scene; else body, or points for a point, for an open mesh and"
            + " with --points."
      })
  private String clearance;

  @Option(
      names = "--rotational-stiffness",
      paramLabel = "N MM/RAD",
      description =
          "Torque of a tool for each radian between device and tool. Default: the stiffness times"
              + " the squared rms radius of the tool.")
  private Double rotationalStiffness;

  @Option(
      names = "--mass",
      paramLabel = "KG",
      description =
          "Mass of an interaction point or a rigid tool, which the hand then feels. A tool has"
              + " inertia against turning too.")
  private Double mass;

  @Option(
      names = "--gravity",
      paramLabel = "X,Y,Z",
      description =
          "Gravity on the mass, m/s^2 along the world's axes, as in" + " 0,0,-9.81. Default: none.")
  private String gravity;

  private static final NumberRange MASS =
      new NumberRange(
          "--mass", "the mass", NumberRange.LEAST, NumberRange.MOST, "kg", "0.05 for 50 g");

  private static final double MOST_GRAVITY = 100;
  private static final double MM_PER_M = 1e3;

  /** The option that names bodies with poses, with its value; empty without such bodies. */
  private Optional<String> placedBodies = Optional.empty();

  /**
   * Takes the tool of a scene file; a clearance that was given replaces its own. Among bodies that
   * have poses even a point is a rigid tool.
   *
   * @throws VolumeFormatException if the scene cannot be read
   * @throws PalpateException exit code 2, if an option contradicts the scene
   */
  public void takeFrom(VolumeOptions volume, ParseResult given) throws VolumeFormatException {
    placedBodies = volume.isPlaced() ? Optional.of(volume.named()) : Optional.empty();
    if (volume.scene().isEmpty()) {
      return;
    }
    for (String option : List.of("--tool", "--tool-segment", "--mass")) {
      if (given.hasMatchedOption(option)) {
        throw PalpateException.wrongUse(
            "the scene names the tool",
            option + " with --scene",
            "change the key tool of the scene");
      }
    }
    Path file = volume.scene().get();
    SceneReader.read(file).tool().ifPresent(own -> take(own, file));
  }

  private void take(SceneTool own, Path sceneFile) {
    tool =
        own.isFile()
            ? sceneFile.toAbsolutePath().resolveSibling(own.spec()).toString()
            : own.spec();
    segment = own.segment().orElse(null);
    clearance = clearance == null ? own.clearance().orElse(null) : clearance;
    mass = own.massKg().isPresent() ? own.massKg().getAsDouble() : null;
  }

  /** Whether the tool is more than a point, or a point among bodies that have poses. */
  public boolean isRigid() throws VolumeFormatException {
    return placedBodies.isPresent() || !(request().spec() instanceof ToolSpec.Point);
  }

  /** Whether the tool is a needle, which may enter tissue. */
  public boolean isNeedle() throws VolumeFormatException {
    return request().spec() instanceof ToolSpec.Shape rod
        && rod.shape() instanceof RodShape needle
        && needle.roundLow()
        && !needle.roundHigh();
  }

  /**
   * Returns the torque per angle, N mm/rad; empty for the default.
   *
   * @throws PalpateException exit code 2, if it is out of range
   */
  public OptionalDouble rotationalStiffness() {
    return NumberRange.positive("--rotational-stiffness", "the rotational stiffness", "N mm/rad")
        .checkGiven(rotationalStiffness);
  }

  /**
   * Returns the mass, kg, if it was given.
   *
   * @throws PalpateException exit code 2, if it is out of range
   */
  public OptionalDouble massKg() {
    return MASS.checkGiven(mass);
  }

  /**
   * Returns the mass of the interaction point or tool with gravity, if it has a mass.
   *
   * @throws PalpateException exit code 2, if a number is out of range or gravity has no mass
   */
  public Optional<MassSettings> massOfHeld() {
    OptionalDouble kg = massKg();
    Vec3 acceleration = gravityMmPerSecond2();
    if (gravity != null && kg.isEmpty()) {
      throw PalpateException.wrongUse(
          "gravity needs a mass", "--gravity " + gravity, "add --mass 0.05");
    }
    return kg.isPresent()
        ? Optional.of(new MassSettings(kg.getAsDouble(), acceleration))
        : Optional.empty();
  }

  /**
   * Returns plain contact with the mass of the interaction point or tool, if it has one.
   *
   * @throws PalpateException exit code 2, as {@link #massOfHeld}
   */
  public FeelSettings feel() {
    return new FeelSettings(List.of(), massOfHeld(), Optional.empty());
  }

  private Vec3 gravityMmPerSecond2() {
    Vec3 found = new Vec3();
    String[] words = gravity == null ? new String[] {"0", "0", "0"} : gravity.split(",", -1);
    for (int axis = 0; axis < words.length && axis < 3; axis++) {
      found.set(axis, NumberParser.number(words[axis]));
    }
    if (words.length != 3 || !(found.length() <= MOST_GRAVITY)) {
      throw PalpateException.wrongUse(
          "gravity must be three numbers, together at most 100 m/s^2",
          "--gravity " + gravity,
          "try --gravity 0,0,-9.81");
    }
    return found.mul(MM_PER_M, found);
  }

  /**
   * Checks the numbers, and refuses options that do not fit the tool.
   *
   * @throws PalpateException exit code 2, if a number is out of range or an option does not fit
   */
  public void checkOthers(ParseResult given) throws VolumeFormatException {
    checkOthers(given, isRigid());
  }

  /**
   * Checks the numbers, and refuses options that do not fit.
   *
   * @param rigid whether the tool moves as a rigid tool, as a point does among moving bodies
   * @throws PalpateException exit code 2, if a number is out of range or an option does not fit
   */
  public void checkOthers(ParseResult given, boolean rigid) throws VolumeFormatException {
    rotationalStiffness();
    massOfHeld();
    List<String> unfit = rigid ? OF_POINTS : OF_RIGID_TOOLS;
    for (String option : unfit) {
      if (given.hasMatchedOption(option)) {
        throw PalpateException.wrongUse(
            rigid ? "this option is for a point alone" : "this option is for a rigid tool alone",
            option + " with --tool " + tool,
            "leave one of them out");
      }
    }
  }

  /**
   * Returns the tool of a scene, in the world of its volume and for its smallest voxels.
   *
   * @throws VolumeFormatException if an option is wrong, a file cannot be read, or nothing would be
   *     left of the tool
   */
  public MadeTool make(VolumeSource source) throws VolumeFormatException {
    return ToolMaker.make(request(), source.shortestEdgeMm(), source.header().coordinateSystem());
  }

  /**
   * Returns the scene of a tool among the segments of a contact scene. Those that are placed as
   * movable can move.
   *
   * @throws VolumeFormatException if the clearance is too large or does not fit in memory, or
   *     segments of which one can move overlap
   */
  public ToolScene scene(ContactScene scene, MadeTool made) throws VolumeFormatException {
    return scene(scene, made, Set.of(), CollisionDevice.CPU);
  }

  /**
   * Returns the scene of a tool among the segments of a contact scene.
   *
   * @param movable the indices of the segments that can move besides those that are placed so
   * @param device judges the legs of the tool and of bodies
   * @throws VolumeFormatException if the clearance is too large or does not fit in memory, or
   *     segments of which one can move overlap
   */
  public ToolScene scene(
      ContactScene scene, MadeTool made, Set<Integer> movable, CollisionDevice device)
      throws VolumeFormatException {
    BodyScene bodies = scene.newBodies(movable);
    try {
      return new ToolScene(
          scene,
          bodies,
          made.tool(),
          made.movableShapes(bodies),
          made.clearances(bodies, scene.settings().protectedMm()),
          rotationalStiffness(),
          device);
    } catch (RigidScene.BodiesOverlapException e) {
      throw new VolumeFormatException(
          e.getMessage(),
          placedBodies.orElse("--poses"),
          placedBodies.isPresent()
              ? "change the pose of one of them; palpate info prints by how much they overlap"
              : "choose segments that do not overlap",
          e);
    }
  }

  /**
   * Returns the tool that was asked for.
   *
   * @throws VolumeFormatException if an option is not understood or does not fit the others
   */
  public ToolRequest request() throws VolumeFormatException {
    return ToolRequest.parse(tool, segment, points, clearance);
  }
}
