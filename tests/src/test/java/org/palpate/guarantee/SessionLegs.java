package org.palpate.guarantee;

import java.io.IOException;
import java.util.Optional;
import org.palpate.device.DeviceState;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.ReplayRun;
import org.palpate.host.SolverKind;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.raycast.Ray;
import org.palpate.testing.ExactOracle;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Counts violations of the guarantee by the legs of a simulated session. */
final class SessionLegs implements ReplayRun.FrameSink {
  private static final long PERIOD_NANOS = 1_000_000;

  private final BitCube[] cubes;
  private final Ray ray = new Ray();
  private final Vec3 end = new Vec3();
  private boolean chained;
  private long legs;
  private long contactFrames;
  private long legsThroughSolids;
  private long brokenChains;
  private String firstFault = "";

  private SessionLegs(SegmentedVolume volume) {
    cubes = volume.segments().stream().map(Segment::bits).toArray(BitCube[]::new);
  }

  /** Runs a session of a seeded hand over a volume. */
  static SessionLegs of(SegmentedVolume volume, SolverKind solver, long seed, int frames)
      throws IOException {
    return of(volume, solver, Optional.empty(), seed, frames);
  }

  /** Runs the session over the grey values from which the volume's one segment was made. */
  static SessionLegs of(
      SegmentedVolume volume,
      SolverKind solver,
      Optional<GreyIsosurface> grey,
      long seed,
      int frames)
      throws IOException {
    ContactSettings settings = ContactSettings.standard(solver);
    ContactScene scene = new ContactScene(volume, settings, grey);
    SessionLegs session = new SessionLegs(volume);
    ReplayRun.inWorld(scene, hand(scene, seed, frames)).run(session);
    return session;
  }

  private static Trajectory hand(ContactScene scene, long seed, int frames) {
    Trajectory trajectory = new Trajectory();
    DeviceState state = new DeviceState();
    try (SimulatedDevice device = new SimulatedDevice(seed, scene.handTarget(), PERIOD_NANOS)) {
      for (int frame = 0; frame < frames; frame++) {
        device.read(state);
        Vec3 p = state.positionMm;
        trajectory.add(frame, p.x, p.y, p.z);
      }
    }
    return trajectory;
  }

  @Override
  public void accept(
      int frame, Vec3 device, Vec3 point, Vec3 forceNewton, InteractionPoint state, boolean freed) {
    chained &= !freed;
    contactFrames += state.contact ? 1 : 0;
    LegPath path = state.legs;
    for (int leg = 0; leg < path.count(); leg++) {
      legs++;
      ray.from(path.start(leg, 0), path.start(leg, 1), path.start(leg, 2));
      ray.to(path.end(leg, 0), path.end(leg, 1), path.end(leg, 2));
      judge(frame, leg);
    }
    if (chained && !end.sameBits(state.position)) {
      brokenChains++;
    }
    end.set(state.position);
    chained = true;
  }

  private void judge(int frame, int leg) {
    if (chained && !end.sameBits(new Vec3(ray.fromX, ray.fromY, ray.fromZ))) {
      brokenChains++;
      recordFault("starts elsewhere", frame, leg);
    }
    for (BitCube cube : cubes) {
      if (ExactOracle.touchesAny(cube, ray)) {
        legsThroughSolids++;
        recordFault("touches a solid", frame, leg);
        break;
      }
    }
    end.set(ray.toX, ray.toY, ray.toZ);
    chained = true;
  }

  private void recordFault(String what, int frame, int leg) {
    if (firstFault.isEmpty()) {
      firstFault = "frame " + frame + " leg " + leg + " " + what + ": " + ray;
    }
  }

  /** Returns the number of legs. */
  long legs() {
    return legs;
  }

  /** Returns the number of frames with contact. */
  long contactFrames() {
    return contactFrames;
  }

  /** Returns the number of legs that touch a closed solid voxel. */
  long legsThroughSolids() {
    return legsThroughSolids;
  }

  /**
   * Returns the number of legs that do not start, or frames that do not end, at the last leg's end.
   */
  long brokenChains() {
    return brokenChains;
  }

  /** Returns the first fault; empty if there is none. */
  String firstFault() {
    return firstFault;
  }
}
