package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.ClipPlane.Direction;

class ClipPlaneTest {
  private static final Vec3 POINT = new Vec3(5, 6, 7);

  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.DARK);
  private final AtomicInteger redraws = new AtomicInteger();

  private void addCube() {
    model.add("a", 0, RigidTransform.identity(), new Vec3(), new Vec3(10, 10, 10));
    model.onChange(redraws::incrementAndGet);
  }

  private void clip(Direction direction) {
    model.clip(new ClipPlane.Start(direction, OptionalDouble.empty()));
  }

  private static TouchMarks marks(double x) {
    return new TouchMarks(new Vec3(), new Vec3(x, 5, 5), new Vec3(), true, List.of());
  }

  @Test
  void theDirectionsComeRound() {
    Set<Direction> seen = EnumSet.noneOf(Direction.class);
    Direction direction = Direction.OFF;
    while (seen.add(direction)) {
      direction = direction.next();
    }
    assertEquals(Direction.OFF, direction);
    assertEquals(EnumSet.allOf(Direction.class), seen);
    assertEquals("view", Direction.VIEW.toString());
  }

  @Test
  void theViewersSideIsHidden() {
    for (StandardView view : StandardView.values()) {
      Camera camera = Camera.seeing(POINT, List.of(new Vec3(90, 90, 90)), view, 1);
      assertEquals(Optional.empty(), Direction.OFF.through(POINT, camera));
      for (Direction direction : List.of(Direction.X, Direction.Y, Direction.Z, Direction.VIEW)) {
        ClipPlane plane = direction.through(POINT, camera).orElseThrow();
        Vec3 towardsViewer = camera.eye().sub(POINT, new Vec3());
        assertTrue(plane.normal().dot(towardsViewer) >= -1e-9, view + " " + direction);
        assertEquals(1, plane.normal().length(), 1e-12);
        assertTrue(plane.point().sameBits(POINT));
      }
    }
    Camera tilted = Camera.seeing(POINT, List.of(), StandardView.FRONT, 1).orbit(0.4, 0.3);
    ClipPlane facing = Direction.VIEW.through(POINT, tilted).orElseThrow();
    assertTrue(facing.normal().sameBits(tilted.back()), "a plane of the view faces the viewer");
    Camera back = Camera.seeing(POINT, List.of(), StandardView.BACK, 1);
    assertEquals(
        "(0.0, 1.0, 0.0)", Direction.Y.through(POINT, back).orElseThrow().normal().toString());
  }

  @Test
  void aPlaneStaysWhereItWasMadeWhenThePointMovesOn() {
    Camera camera = Camera.seeing(POINT, List.of(), StandardView.FRONT, 1);
    for (Direction direction : List.of(Direction.X, Direction.VIEW)) {
      Vec3 point = new Vec3().set(POINT);
      ClipPlane plane = direction.through(point, camera).orElseThrow();
      point.set(0, 0, 0);
      assertTrue(plane.point().sameBits(POINT), direction.toString());
    }
  }

  @Test
  void beforeAPointIsKnownThePlaneCutsTheMiddle() {
    addCube();
    assertFalse(model.state().clip().isPresent());
    clip(Direction.X);
    assertEquals(1, redraws.get());
    assertEquals("(5.0, 5.0, 5.0)", model.state().clip().orElseThrow().point().toString());
    model.clipNext();
    assertEquals(0, model.state().clip().orElseThrow().normal().x);
    for (int n = 0; n < 3; n++) {
      model.clipNext();
    }
    assertFalse(model.state().clip().isPresent());
  }

  @Test
  void thePlaneFollowsThePointInSteps() {
    addCube();
    model.setMarks(Optional.of(marks(2)));
    assertFalse(model.state().clip().isPresent());
    clip(Direction.Z);
    long revision = model.state().staticRevision();
    model.setMarks(Optional.of(marks(3)));
    assertEquals(3, model.state().clip().orElseThrow().point().x);
    assertTrue(model.state().staticRevision() > revision, "surfaces must be drawn again");
    revision = model.state().staticRevision();
    double step = 0.005 * model.state().radiusMm();
    model.setMarks(Optional.of(marks(3 + 0.99 * step)));
    assertEquals(3, model.state().clip().orElseThrow().point().x);
    assertEquals(revision, model.state().staticRevision());
    model.setMarks(Optional.of(marks(3 + 1.01 * step)));
    assertEquals(3 + 1.01 * step, model.state().clip().orElseThrow().point().x);
    model.setMarks(Optional.empty());
    assertEquals(3 + 1.01 * step, model.state().clip().orElseThrow().point().x);
  }
}
