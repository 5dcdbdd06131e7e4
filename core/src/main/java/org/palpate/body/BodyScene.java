package org.palpate.body;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The bodies of a scene, in the order in which results number them. Haptic thread only. */
public final class BodyScene {
  private final Body[] bodies;
  private final List<Pose> poses;
  private final double shortestEdgeMm;

  /**
   * Creates a scene of at least one body.
   *
   * @param bodies in the order of their indices; the list is copied
   * @throws IllegalArgumentException if there is no body
   */
  public BodyScene(List<Body> bodies) {
    if (bodies.isEmpty()) {
      throw new IllegalArgumentException("a scene needs at least one body");
    }
    this.bodies = bodies.toArray(new Body[0]);
    double shortest = Double.POSITIVE_INFINITY;
    List<Pose> all = new ArrayList<>();
    for (Body body : bodies) {
      all.add(body.pose());
      shortest = Math.min(shortest, body.metric().shortestEdgeMm());
    }
    poses = List.copyOf(all);
    shortestEdgeMm = shortest;
  }

  /** {@return the pose of each body; it follows the body and is not to be written} */
  public List<Pose> poses() {
    return poses;
  }

  /** {@return the number of bodies} */
  public int count() {
    return bodies.length;
  }

  /**
   * {@return a body}
   *
   * @param index the index of the body, from 0 to {@link #count} - 1
   */
  public Body body(int index) {
    return bodies[index];
  }

  /** {@return the grid of each body} */
  public List<VoxelGrid> grids() {
    List<VoxelGrid> grids = new ArrayList<>();
    for (Body body : bodies) {
      grids.add(body.grid());
    }
    return grids;
  }

  /** {@return the voxels of each body; not copied} */
  public List<BitCube> cubes() {
    List<BitCube> cubes = new ArrayList<>();
    for (Body body : bodies) {
      cubes.add(body.bits());
    }
    return cubes;
  }

  /** {@return the number of times that the pose of any body was set} */
  public long motions() {
    long sum = 0;
    for (Body body : bodies) {
      sum += body.motions();
    }
    return sum;
  }

  /** {@return the number of edits of all bodies} */
  public long edits() {
    long sum = 0;
    for (Body body : bodies) {
      sum += body.edits();
    }
    return sum;
  }

  /** {@return the shortest voxel edge of all bodies, mm} */
  public double shortestEdgeMm() {
    return shortestEdgeMm;
  }
}
