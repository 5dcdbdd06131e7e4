package org.palpate.host;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.palpate.geometry.Vec3;
import org.palpate.scene.window.PointerListener;
import org.palpate.scene.window.PointerSpot;

/**
 * Touches with the mouse what the user sees: a press begins in front of the first solid on the line
 * of sight and goes on into it, so that the point meets the face that was pressed.
 *
 * <p>The drawing thread presses; any thread frees the point. A press reads voxels that may change
 * meanwhile; see {@link DrawnSolids.Probe}. The haptic frame checks the position again before it
 * sets the interaction point free there.
 */
final class MouseTouch implements PointerListener {
  static final String NOTHING_THERE = "nothing to touch there: press on a surface";

  /** Distance from the start of a press to the surface, as a multiple of the longest voxel edge. */
  private static final double CLEAR_VOXELS = 1.5;

  /** Largest distance from a drawn surface to the nearest solid, voxels. */
  private static final int DRAWN_VOXELS = 2;

  /** Radius of the ball whose solid voxels give the direction of a press, voxels. */
  private static final double NORMAL_VOXELS = 3;

  /** Largest radius of that ball along an axis with short voxel edges, voxels. */
  private static final int MAX_NORMAL_REACH = 12;

  /** The least cosine between the line of sight and the direction of a press. */
  private static final double LEAST_INWARD = 0.1;

  /** A drag moved to another surface if its change of depth exceeds this multiple of its width. */
  private static final double STEEPEST = 4;

  /** Smallest change of depth that counts as another surface, as a fraction of the radius. */
  private static final double JUMP_FRACTION = 0.03;

  /** Distance from the surface to which a freed point withdraws, as a fraction of the radius. */
  private static final double WITHDRAWAL_FRACTION = 0.15;

  private final DrawnSolids.Probe solids;
  private final MouseDevice mouse;
  private final Consumer<String> hints;
  private final double voxelMm;
  private final double radiusMm;

  /** The last pressed point of a solid, world mm; empty if the last press met no solid. */
  private Optional<Vec3> lastFaceMm = Optional.empty();

  private volatile Optional<Vec3> withdrawnMm = Optional.empty();

  /**
   * Creates a listener.
   *
   * @param solids the drawn segments
   * @param mouse the device to move
   * @param hints receives a line if there is nothing to touch; empty if there is
   */
  MouseTouch(DrawnSolids solids, MouseDevice mouse, Consumer<String> hints) {
    this.solids = new DrawnSolids.Probe(solids);
    this.mouse = mouse;
    this.hints = hints;
    voxelMm = this.solids.longestEdgeMm();
    radiusMm = mouse.specification().workspaceRadiusMm();
  }

  @Override
  public boolean press(PointerSpot spot) {
    solids.refresh();
    Optional<Vec3> face = face(spot);
    if (face.isPresent()) {
      press(spot, face.get());
      hints.accept("");
    } else if (spot.begins()) {
      pressedBackground();
    }
    boolean touches = face.isPresent();
    lastFaceMm = face;
    return touches;
  }

  @Override
  public void pressedBackground() {
    lastFaceMm = Optional.empty();
    hints.accept(NOTHING_THERE);
  }

  /**
   * Withdraws device and interaction point to a position in front of the spot that was pressed
   * last. Any thread.
   */
  void free() {
    withdrawnMm.ifPresent(position -> mouse.jump(position, position));
  }

  /**
   * Returns the point at which the line of sight meets the first solid, world mm; empty if no solid
   * is near the spot or the viewer is inside one.
   */
  private Optional<Vec3> face(PointerSpot spot) {
    Vec3 sight = spot.surfaceMm().sub(spot.eyeMm(), new Vec3());
    double reach = 1 + DRAWN_VOXELS * voxelMm / sight.length();
    Vec3 beyond = spot.eyeMm().add(sight.mul(reach, sight), sight);
    Optional<Vec3> straight = firstHit(spot.eyeMm(), beyond);
    return straight.isPresent()
        ? straight
        : solidNear(spot.surfaceMm()).flatMap(solid -> firstHit(spot.eyeMm(), solid));
  }

  private Optional<Vec3> firstHit(Vec3 fromMm, Vec3 toMm) {
    OptionalDouble hit = solids.firstHit(fromMm, toMm);
    return hit.orElse(0) > 0
        ? Optional.of(along(fromMm, toMm, hit.getAsDouble() * distance(fromMm, toMm)))
        : Optional.empty();
  }

  /** Returns the centre of a solid voxel next to a drawn point, world mm: the nearest one. */
  private Optional<Vec3> solidNear(Vec3 drawnMm) {
    List<Vec3> centres = new ArrayList<>();
    solids.around(drawnMm, Double.POSITIVE_INFINITY, DRAWN_VOXELS, centres::add);
    return centres.stream().min(Comparator.comparingDouble(centre -> distance(centre, drawnMm)));
  }

  /**
   * Returns a unit vector into the solid at a face, so that the point stays where it was pressed:
   * towards the mean of the solid voxels around it, or along the line of sight if that leads out.
   */
  private Vec3 inward(Vec3 eyeMm, Vec3 faceMm) {
    Vec3 sight = unit(faceMm.sub(eyeMm, new Vec3()));
    Vec3 sum = new Vec3();
    double reachMm = NORMAL_VOXELS * voxelMm;
    solids.around(faceMm, reachMm, MAX_NORMAL_REACH, centre -> addIfNear(centre, faceMm, sum));
    boolean isClear = sum.length() > 0 && sum.dot(sight) >= LEAST_INWARD * sum.length();
    return isClear ? unit(sum) : sight;
  }

  /** Adds the direction from a face to the centre of a voxel if it is near. */
  private void addIfNear(Vec3 centre, Vec3 faceMm, Vec3 sum) {
    centre.sub(faceMm, centre);
    if (centre.length() <= NORMAL_VOXELS * voxelMm) {
      sum.add(centre, sum);
    }
  }

  private static double distance(Vec3 a, Vec3 b) {
    return b.sub(a, new Vec3()).length();
  }

  private static Vec3 unit(Vec3 vector) {
    return vector.mul(1 / vector.length(), vector);
  }

  private void press(PointerSpot spot, Vec3 faceMm) {
    Vec3 eye = spot.eyeMm();
    double distance = distance(eye, faceMm);
    Vec3 targetMm = inward(eye, faceMm);
    targetMm.mul(spot.depthMm(), targetMm).add(faceMm, targetMm);
    double clear = Math.min(CLEAR_VOXELS * voxelMm, distance / 2);
    double withdrawal = Math.min(Math.max(WITHDRAWAL_FRACTION * radiusMm, clear), distance / 2);
    withdrawnMm = Optional.of(along(eye, faceMm, distance - withdrawal));
    if (spot.begins() || isAnotherSurface(eye, faceMm)) {
      mouse.jump(along(eye, faceMm, distance - clear), targetMm);
    } else {
      mouse.moveTo(targetMm);
    }
  }

  /** Whether a drag went from one surface to another, as from a nose to the wall behind it. */
  private boolean isAnotherSurface(Vec3 eyeMm, Vec3 faceMm) {
    if (lastFaceMm.isEmpty()) {
      return true;
    }
    Vec3 moved = faceMm.sub(lastFaceMm.get(), new Vec3());
    Vec3 sight = faceMm.sub(eyeMm, new Vec3());
    double deeper = Math.abs(moved.dot(sight)) / sight.length();
    double wide = Math.sqrt(Math.max(0, moved.dot(moved) - deeper * deeper));
    return deeper > STEEPEST * wide + JUMP_FRACTION * radiusMm;
  }

  /** Returns the point at a distance from {@code fromMm} on the line to {@code toMm}. */
  private static Vec3 along(Vec3 fromMm, Vec3 toMm, double distanceMm) {
    Vec3 towards = toMm.sub(fromMm, new Vec3());
    return towards.mul(distanceMm / towards.length(), towards).add(fromMm, towards);
  }
}
