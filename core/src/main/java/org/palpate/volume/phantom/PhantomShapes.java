package org.palpate.volume.phantom;

import java.util.Optional;
import org.palpate.geometry.Vec3;

/** The sizes and positions of the simple phantoms, for their voxels and their analytic surfaces. */
final class PhantomShapes {
  /** The offset from the centre of the cube, voxels, which avoids symmetry with the grid. */
  private static final Vec3 OFF_GRID_VOXELS = new Vec3(0.137, 0.291, -0.213);

  private static final double BALL_RADIUS_FRACTION = 63.6 / 192;
  private static final double RING_RADIUS_FRACTION = 63.6 / 192;
  private static final double TUBE_RADIUS_FRACTION = 21.1 / 192;

  private PhantomShapes() {}

  /** Returns the anatomy of a phantom that is no maze. */
  static Anatomy anatomy(Phantom.Kind kind, int edge, boolean grey) {
    Vec3 centre = centre(edge);
    double radius = BALL_RADIUS_FRACTION * edge;
    return switch (kind) {
      case SPHERE -> new SimpleAnatomy(Shape.ball(centre, radius), SimpleAnatomy.Filling.SOLID);
      case SHELL ->
          new SimpleAnatomy(
              Shape.ball(centre, radius),
              grey ? SimpleAnatomy.Filling.SHELL : SimpleAnatomy.Filling.VOXEL_WALL);
      case PLANE ->
          new SimpleAnatomy(Shape.halfSpace(centre, planeNormal()), SimpleAnatomy.Filling.SOLID);
      case TORUS ->
          new SimpleAnatomy(
              Shape.torus(centre, RING_RADIUS_FRACTION * edge, TUBE_RADIUS_FRACTION * edge),
              SimpleAnatomy.Filling.SOLID);
      case HEAD -> new HeadAnatomy(edge);
      case BLOCK -> new BlockAnatomy(edge);
      case MAZE -> throw new IllegalArgumentException("a maze has no shapes: kind=MAZE");
    };
  }

  /** Returns the analytic surface of a phantom; empty for a head, a maze or a block. */
  static Optional<AnalyticSurface> analyticSurface(Phantom.Kind kind, int edge) {
    Vec3 centre = centre(edge);
    double radius = BALL_RADIUS_FRACTION * edge;
    return switch (kind) {
      case SPHERE -> Optional.of(new AnalyticSurfaces.Ball(centre, radius));
      case SHELL -> Optional.of(new AnalyticSurfaces.Wall(centre, radius));
      case PLANE -> Optional.of(new AnalyticSurfaces.Plane(centre, planeNormal()));
      case TORUS ->
          Optional.of(
              new AnalyticSurfaces.Ring(
                  centre, RING_RADIUS_FRACTION * edge, TUBE_RADIUS_FRACTION * edge));
      case HEAD, MAZE, BLOCK -> Optional.empty();
    };
  }

  private static Vec3 centre(int edge) {
    double middle = edge / 2.0;
    return new Vec3(middle, middle, middle).add(OFF_GRID_VOXELS, new Vec3());
  }

  /** Returns a normal whose slopes repeat nowhere in the grid. */
  private static Vec3 planeNormal() {
    Vec3 normal = new Vec3(0.231, 0.377, 0.894);
    return normal.mul(1 / normal.length(), normal);
  }
}
