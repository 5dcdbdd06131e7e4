package org.palpate.app.options;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.palpate.app.process.PalpateException;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReplayDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Trajectory;
import org.palpate.device.Workspace;
import org.palpate.device.WorkspaceDevice;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.MouseDevice;
import org.palpate.io.table.TrajectoryCsvReader;
import org.palpate.io.volume.VolumeHeader;

/**
 * The device that {@code --device NAME[:ID]} asks for.
 *
 * @param name of the back end
 * @param id seed, file, serial, name or host; empty where none was given
 * @param eachAxis whether a real one's reach is stretched over the box along each axis by itself
 */
public record DeviceChoice(String name, String id, boolean eachAxis) {
  private static final String SIMULATED = "simulated";
  private static final String REPLAY = "replay";
  private static final String MOUSE = "mouse";
  private static final String FORMS =
      "write simulated[:SEED], replay:T.csv, hid[:SERIAL], openhaptics[:NAME],"
          + " forcedimension[:SERIAL], virtuose:HOST or mouse";
  private static final Set<String> NEED_ID = Set.of(REPLAY, "virtuose");
  private static final long DEFAULT_SEED = 1;

  /** Half of what a real device renders stably. */
  private static final double STIFFNESS_FRACTION = 0.5;

  /** Reads the argument of {@code --device}. */
  public static DeviceChoice parse(String argument) {
    int colon = argument.indexOf(':');
    String name = colon < 0 ? argument : argument.substring(0, colon);
    String id = colon < 0 ? "" : argument.substring(colon + 1);
    DeviceChoice choice = new DeviceChoice(name, id, false);
    boolean known =
        name.equals(SIMULATED)
            || name.equals(REPLAY)
            || name.equals(MOUSE)
            || (DeviceCatalog.isNative(name) && !name.equals("empty"));
    if (!known) {
      throw choice.wrong("there is no such device");
    }
    if (id.isEmpty() && NEED_ID.contains(name)) {
      throw choice.wrong("it is not said which");
    }
    if (name.equals(SIMULATED)) {
      choice.seed();
    }
    return choice;
  }

  /**
   * The same device, its reach fitted to each axis where {@code wanted}.
   *
   * @throws PalpateException where it is no real one, which has a reach
   */
  public DeviceChoice withFitEachAxis(boolean wanted) {
    if (wanted && !isReal()) {
      throw PalpateException.wrongUse(
          "only a real device's reach is fitted",
          "--fit-each-axis --device " + this,
          "leave it out, or choose hid, openhaptics, forcedimension or virtuose");
    }
    return new DeviceChoice(name, id, wanted);
  }

  private PalpateException wrong(String what) {
    return PalpateException.wrongUse(what, "--device " + this, FORMS);
  }

  private long seed() {
    try {
      return id.isEmpty() ? DEFAULT_SEED : Long.parseLong(id);
    } catch (NumberFormatException e) {
      throw wrong("the seed is no whole number");
    }
  }

  /** Files that it reads, which must not be written. */
  public List<Path> files() {
    return name.equals(REPLAY) ? List.of(Path.of(id)) : List.of();
  }

  /** Whether its end is the end of what was asked for. */
  public boolean ends() {
    return name.equals(REPLAY);
  }

  /** Whether it feels what is sent: a hand holds it. */
  boolean isReal() {
    return !name.equals(SIMULATED) && !name.equals(REPLAY) && !name.equals(MOUSE);
  }

  /**
   * Opens it, mapped to the world.
   *
   * @param target what is to be in reach
   * @param world which way the world's axes point
   */
  public HapticDevice open(HandTarget target, VolumeHeader.World world, long periodNanos)
      throws IOException {
    return switch (name) {
      case SIMULATED -> new SimulatedDevice(seed(), target, periodNanos);
      case MOUSE -> new MouseDevice(target, periodNanos);
      case REPLAY -> openReplay();
      default -> openReal(target, world);
    };
  }

  private HapticDevice openReplay() throws IOException {
    Trajectory trajectory = new Trajectory();
    TrajectoryCsvReader.read(Path.of(id), false, trajectory::add);
    return new ReplayDevice(toString(), trajectory);
  }

  private HapticDevice openReal(HandTarget target, VolumeHeader.World world) {
    try {
      HapticDevice device = DeviceCatalog.open(name, id);
      DeviceSpecification reach = device.specification();
      Workspace workspace =
          eachAxis
              ? Workspace.fitEachAxis(reach, axes(world), target.lowMm(), target.highMm())
              : Workspace.fit(reach, axes(world), target.lowMm(), target.highMm());
      return new WorkspaceDevice(device, workspace, WorkspaceDevice.Controls.standard());
    } catch (DeviceException e) {
      throw PalpateException.failed(e.getMessage(), e);
    }
  }

  /**
   * The person looks at the patient's face: what is right for the hand is the patient's left, up is
   * the head, towards the person is the front.
   */
  private static RigidTransform axes(VolumeHeader.World world) {
    boolean ras = world == VolumeHeader.World.RAS;
    Vec3 right = new Vec3(ras ? -1 : 1, 0, 0);
    Vec3 up = new Vec3(0, 0, 1);
    Vec3 towardsPerson = new Vec3(0, ras ? 1 : -1, 0);
    return new RigidTransform(right, up, towardsPerson, new Vec3());
  }

  /** Stiffness where none was asked for, N per mm of scan. */
  public double defaultStiffness(HapticDevice opened) {
    return isReal()
        ? STIFFNESS_FRACTION * opened.specification().maxStiffnessNewtonPerMm()
        : ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM;
  }

  /** As on the command line. */
  @Override
  public String toString() {
    return id.isEmpty() ? name : name + ":" + id;
  }
}
