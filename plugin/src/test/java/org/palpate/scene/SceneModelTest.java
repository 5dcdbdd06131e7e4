package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneState.DrawnObject;

class SceneModelTest {
  private static final int BONE_RGB = 0xe9dcc0;

  private final SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
  private final SceneObject bone =
      model.add("bone", BONE_RGB, RigidTransform.identity(), new Vec3(), new Vec3(2, 4, 6));
  private final AtomicInteger redraws = new AtomicInteger();

  @Test
  void aChangeRequestsOneRedrawAndItsRepetitionNone() {
    model.onChange(redraws::incrementAndGet);
    List<Runnable> changes =
        List.of(
            () -> model.setColour(bone, Palette.POINT),
            () -> model.setOpacity(bone, 0.5),
            () -> model.setVisible(bone, false),
            () -> model.changeLook(look -> look.with(Stereo.ANAGLYPH)),
            () -> model.setOverlay(List.of("1 kHz")),
            () -> model.setHelp(List.of("h: help")));
    for (int done = 0; done < changes.size(); done++) {
      changes.get(done).run();
      changes.get(done).run();
      assertEquals(done + 1, redraws.get());
    }
  }

  @Test
  void laterChangesDoNotAffectAState() {
    SceneState before = model.state();
    model.setColour(bone, Palette.POINT);
    model.setOpacity(bone, 0.5);
    DrawnObject then = before.objects().get(0);
    assertEquals(BONE_RGB, then.rgb());
    assertEquals(1, then.opacity());
    assertTrue(before.staticRevision() < model.state().staticRevision());
  }

  @Test
  void aGhostIsAFaintCopyAtAnotherPoseUntilItIsHidden() {
    RigidTransform there = RigidTransform.identity();
    there.origin().set(5, 0, 0);
    model.setGhost(bone, Optional.of(there));
    List<DrawnObject> drawn = model.state().objects();
    assertEquals(2, drawn.size());
    assertEquals(1, drawn.get(0).opacity());
    assertTrue(drawn.get(1).opacity() < 0.5);
    assertEquals(5, Math.abs(drawn.get(1).pose().origin().x));
    assertEquals(0, Math.abs(drawn.get(0).pose().origin().x));
    model.setVisible(bone, false);
    assertEquals(List.of(), model.state().objects());
    model.setVisible(bone, true);
    model.setGhost(bone, Optional.empty());
    assertEquals(1, model.state().objects().size());
  }

  @Test
  void theClippingPlaneTurnsFromAxisToAxisAndThenFacesTheViewer() {
    model.look(StandardView.OBLIQUE, 1);
    assertEquals(Optional.empty(), model.state().clip());
    for (int axis = 0; axis < 3; axis++) {
      model.clipNext();
      ClipPlane plane = model.state().clip().orElseThrow();
      Vec3 toEye = model.camera().eye().sub(plane.point(), new Vec3());
      assertEquals(1, Math.abs(plane.normal().get(axis)));
      assertEquals(1, plane.normal().length());
      assertTrue(plane.normal().dot(toEye) > 0);
    }
    model.clipNext();
    assertAt(model.camera().back(), model.state().clip().orElseThrow().normal());
    model.clipNext();
    assertEquals(Optional.empty(), model.state().clip());
  }

  @Test
  void theClippingPlaneFollowsThePointButNotItsSmallestMotions() {
    model.clipNext();
    model.setMarks(Optional.of(marksAt(new Vec3(1, 2, 3))));
    SceneState before = model.state();
    assertAt(new Vec3(1, 2, 3), before.clip().orElseThrow().point());
    model.setMarks(Optional.of(marksAt(new Vec3(1.001, 2, 3))));
    assertAt(new Vec3(1, 2, 3), model.state().clip().orElseThrow().point());
    assertEquals(before.staticRevision(), model.state().staticRevision());
    model.setMarks(Optional.of(marksAt(new Vec3(1.5, 2, 3))));
    assertAt(new Vec3(1.5, 2, 3), model.state().clip().orElseThrow().point());
    assertTrue(before.staticRevision() < model.state().staticRevision());
  }

  @Test
  void theClippingPlaneLeadsThroughAPointThatRests() {
    model.setMarks(Optional.of(marksAt(new Vec3(1, 2, 3))));
    model.clipNext();
    assertAt(new Vec3(1, 2, 3), model.state().clip().orElseThrow().point());
  }

  @Test
  void aClippingPlaneAtAPlaceOfTheWorldStaysThereUntilItIsTurned() {
    model.clip(new ClipPlane.Start(ClipPlane.Direction.X, OptionalDouble.of(7)));
    model.setMarks(Optional.of(marksAt(new Vec3(1, 2, 3))));
    assertAt(new Vec3(-7, 2, 3), model.state().clip().orElseThrow().point());
    model.clipNext();
    assertAt(new Vec3(1, 2, 3), model.state().clip().orElseThrow().point());
  }

  @Test
  void aPlaneThatFacesTheViewerHasNoPlaceOnAnAxis() {
    OptionalDouble place = OptionalDouble.of(7);
    assertThrows(
        IllegalArgumentException.class, () -> new ClipPlane.Start(ClipPlane.Direction.VIEW, place));
  }

  private static void assertAt(Vec3 expected, Vec3 actual) {
    assertEquals(0, expected.sub(actual, new Vec3()).length());
  }

  private static TouchMarks marksAt(Vec3 point) {
    return new TouchMarks(new Vec3(), point, new Vec3(), false, List.of());
  }

  @Test
  void hiddenAndFullyTransparentSegmentsAreNotDrawn() {
    model.setVisible(bone, false);
    assertEquals(List.of(), model.state().objects());
    model.setVisible(bone, true);
    model.setOpacity(bone, 0);
    assertEquals(List.of(), model.state().objects());
  }

  @Test
  void aMovedSegmentHasANewPoseInTheScene() {
    Vec3 x = new Vec3(1, 0, 0);
    Vec3 y = new Vec3(0, 1, 0);
    Vec3 z = new Vec3(0, 0, 1);
    model.setPose(bone, new RigidTransform(x, y, z, new Vec3(10, 20, 30)));
    Vec3 corner = model.state().objects().get(0).pose().transform(bone.corner(7), new Vec3());
    assertEquals(-12, corner.x, "RAS runs to the right, the scene to the left");
    assertEquals(-24, corner.y);
    assertEquals(36, corner.z);
  }

  @Test
  void theBallAroundTheSceneHoldsEveryBox() {
    assertEquals("(-1.0, -2.0, 3.0)", model.state().middle().toString());
    assertEquals(Math.sqrt(1 + 4 + 9), model.state().radiusMm(), 1e-12);
    RigidTransform far = RigidTransform.identity();
    far.origin().set(10, 0, 0);
    SceneObject other = model.add("other", 0, far, new Vec3(), new Vec3(2, 4, 6));
    assertEquals(-6, model.state().middle().x);
    assertEquals(Math.sqrt(36 + 4 + 9), model.state().radiusMm(), 1e-12);
    model.includeGrid(other, new Vec3(12, 4, 6));
    assertEquals(-11, model.state().middle().x, "the box grew to the whole grid");
  }

  @Test
  void aBoxEnclosesAnotherIfNoSideStandsOut() {
    assertTrue(bone.encloses(box(new Vec3(), new Vec3(2, 4, 6))));
    assertTrue(bone.encloses(box(new Vec3(1, 1, 1), new Vec3(1, 1, 1))));
    for (int axis = 0; axis < 3; axis++) {
      Vec3 low = new Vec3();
      low.set(axis, -0.1);
      assertFalse(bone.encloses(box(low, new Vec3(2, 4, 6))), "axis " + axis);
      Vec3 high = new Vec3(2, 4, 6);
      high.set(axis, high.get(axis) + 0.1);
      assertFalse(bone.encloses(box(new Vec3(), high)), "axis " + axis);
    }
  }

  private SceneObject box(Vec3 low, Vec3 high) {
    return model.add("box", 0, RigidTransform.identity(), low, high);
  }

  @Test
  void theFinestCompleteLevelIsKnown() {
    assertEquals(-1, bone.finestComplete());
    bone.setComplete(2);
    assertEquals(2, bone.finestComplete());
    bone.setComplete(0);
    assertEquals(0, bone.finestComplete());
    assertTrue(bone.isComplete(2) && !bone.isComplete(1));
    assertEquals(0, bone.triangleCount(0));
  }

  @Test
  void theCameraSeesEverythingFromEachSideAndTurnsUpsideDown() {
    for (StandardView view : StandardView.values()) {
      model.look(view, 1.5);
      Vec3 towardsEye = view.towardsEye();
      assertEquals(0, towardsEye.sub(model.camera().back(), towardsEye).length(), 1e-12);
    }
    Vec3 up = new Vec3().set(model.camera().up());
    model.setUpsideDown(true);
    assertTrue(up.sameBits(model.camera().up()), "only the next look turns");
    model.look(StandardView.OBLIQUE, 1.5);
    assertEquals(-1, up.dot(model.camera().up()), 1e-12);
  }

  @Test
  void aMovingCameraIsSaidToMove() {
    model.onChange(redraws::incrementAndGet);
    long revision = model.state().staticRevision();
    model.moveCamera(camera -> camera.zoom(2), true);
    assertTrue(model.state().moving());
    assertTrue(model.state().staticRevision() > revision);
    model.moveCamera(camera -> camera, false);
    assertFalse(model.state().moving());
    assertEquals(2, redraws.get());
  }

  @Test
  void marksAndTextLeaveTheSurfacesAsTheyAre() {
    model.onChange(redraws::incrementAndGet);
    long revision = model.state().staticRevision();
    TouchMarks marks = new TouchMarks(new Vec3(1, 2, 3), new Vec3(), new Vec3(), false, List.of());
    model.setMarks(Optional.of(marks));
    model.setOverlay(List.of("one"));
    model.setHelp(List.of("two"));
    model.setLandmarks(List.of(new NamedPoint("tip", new Vec3(1, 2, 3))));
    SceneState state = model.state();
    assertEquals(revision, state.staticRevision());
    assertEquals(4, redraws.get());
    assertEquals(Optional.of(marks), state.marks());
    assertEquals(List.of("one"), state.overlay());
    assertEquals(List.of("two"), state.help());
    assertEquals("(-1.0, -2.0, 3.0)", state.landmarks().get(0).position().toString());
  }

  @Test
  void theLargestDetailCountsAndARequestRedrawsWithoutAChange() {
    model.addDetail(2);
    model.addDetail(1);
    assertEquals(2, model.state().detailMm());
    model.onChange(redraws::incrementAndGet);
    model.requestRedraw();
    model.surfaceChanged();
    assertEquals(2, redraws.get());
  }
}
