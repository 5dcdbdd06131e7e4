package org.palpate.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Floor;
import org.palpate.testing.SameVoxels;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class UndoHistoryTest {
  private static final int EDGE = Floor.EDGE;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube floor = Floor.bits();
  private final BitCube other = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(floor, other));
  private final EditQueue queue = new EditQueue(Floor.GRID, 2);
  private final List<BitCube[]> states = new ArrayList<>();

  @Test
  void aThousandStrokesAreUndoneAndDoneAgainToTheBit() {
    VoxelWriter writer = new VoxelWriter(scene, EditListener.NONE);
    for (int stroke = 0; stroke < 1000; stroke++) {
      remember();
      while (writer.history().undoable() == stroke) {
        apply(writer, stroke()); // one that changes nothing is no stroke
      }
    }
    remember();
    assertEquals(1000, writer.history().undoable());
    for (int stroke = 999; stroke >= 0; stroke--) {
      apply(writer, HistoryEdit.undo());
      assertState(stroke);
    }
    apply(writer, HistoryEdit.undo());
    assertState(0);
    assertEquals(1000, writer.history().redoable());
    for (int stroke = 1; stroke <= 1000; stroke++) {
      apply(writer, HistoryEdit.redo());
      assertState(stroke);
    }
    apply(writer, HistoryEdit.redo());
    assertState(1000);
  }

  @Test
  void aLogThatIsTooSmallForgetsWholeStrokesAndRestoresTheOthersToTheBit() {
    VoxelWriter writer = new VoxelWriter(scene, EditListener.NONE, 200);
    long[] changes = {0};
    writer.listen((segment, i, j, k, solid) -> changes[0]++);
    int at = 0; // the state in which the voxels are
    remember();
    for (int step = 0; step < 5000; step++) {
      int undoable = writer.history().undoable();
      if (random.nextInt(3) != 0) {
        long before = changes[0];
        apply(writer, stroke());
        if (changes[0] > before) {
          states.subList(++at, states.size()).clear();
          remember();
        }
      } else if (random.nextBoolean()) {
        apply(writer, HistoryEdit.undo());
        at -= undoable > 0 ? 1 : 0;
      } else {
        at += writer.history().redoable() > 0 ? 1 : 0;
        apply(writer, HistoryEdit.redo());
      }
      assertState(at);
      assertTrue(writer.history().undoable() <= at, "step " + step);
    }
    assertTrue(writer.history().undoable() < at, "the log was never full");
  }

  @Test
  void changesOfTheWriterAreOneStrokeUntilItEnds() {
    VoxelWriter writer = new VoxelWriter(scene, EditListener.NONE);
    writer.write(0, 1, 1, 1, false);
    writer.write(1, 9, 9, 9, true);
    writer.write(0, 1, 1, 1, true); // and back
    writer.history().endStroke();
    writer.write(0, 2, 2, 2, false);
    apply(writer, HistoryEdit.undo());
    assertTrue(floor.get(2, 2, 2));
    assertTrue(other.get(9, 9, 9));
    apply(writer, HistoryEdit.undo());
    assertFalse(other.get(9, 9, 9));
    assertTrue(floor.get(1, 1, 1));
    assertEquals(2, writer.history().redoable());
    writer.write(0, 3, 3, 3, false);
    assertEquals(0, writer.history().redoable());
    apply(writer, HistoryEdit.redo());
    assertFalse(floor.get(3, 3, 3));
  }

  @Test
  void aReplacedCubeEndsWhatCanBeUndone() {
    VoxelWriter writer = new VoxelWriter(scene, EditListener.NONE);
    apply(writer, new VoxelEdit(0, 1, 1, 1, false));
    BitCube replacement = Floor.bits();
    apply(writer, new SwapEdit(0, replacement));
    apply(writer, HistoryEdit.undo());
    assertEquals(0, writer.history().undoable());
    assertTrue(replacement.get(1, 1, 1));
    apply(writer, new VoxelEdit(0, 1, 1, 1, false));
    apply(writer, HistoryEdit.undo());
    assertTrue(replacement.get(1, 1, 1));
  }

  @Test
  void listenersReceiveEveryVoxelThatUndoRestores() {
    VoxelWriter writer = new VoxelWriter(scene, EditListener.NONE);
    BitCube[] copies = {floor.copy(), other.copy()};
    writer.listen(
        (segment, i, j, k, solid) -> {
          assertTrue(copies[segment].get(i, j, k) != solid);
          if (solid) {
            copies[segment].set(i, j, k);
          } else {
            copies[segment].clear(i, j, k);
          }
        });
    for (int step = 0; step < 300; step++) {
      int kind = random.nextInt(4);
      apply(writer, kind == 0 ? HistoryEdit.undo() : kind == 1 ? HistoryEdit.redo() : stroke());
      SameVoxels.require(copies[0], floor, "step " + step);
      SameVoxels.require(copies[1], other, "step " + step);
    }
  }

  private Edit stroke() {
    int segment = random.nextInt(2);
    boolean solid = random.nextBoolean();
    if (random.nextInt(3) == 0) {
      int bound = EDGE;
      return new VoxelEdit(
          segment, random.nextInt(bound), random.nextInt(bound), random.nextInt(bound), solid);
    }
    Vec3 centre =
        new Vec3(random.nextDouble(EDGE), random.nextDouble(EDGE), random.nextDouble(EDGE));
    return new BrushEdit(segment, centre, random.nextDouble(4), solid);
  }

  private void apply(VoxelWriter writer, Edit edit) {
    assertTrue(queue.offer(edit));
    while (!edit.isDone()) {
      queue.applyTo(writer, 1 + random.nextInt(400));
    }
  }

  private void remember() {
    states.add(new BitCube[] {floor.copy(), other.copy()});
  }

  private void assertState(int state) {
    SameVoxels.require(states.get(state)[0], floor, "seed " + Seeds.seed() + " state " + state);
    SameVoxels.require(states.get(state)[1], other, "seed " + Seeds.seed() + " state " + state);
  }
}
