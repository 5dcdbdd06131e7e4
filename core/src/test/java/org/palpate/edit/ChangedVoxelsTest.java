package org.palpate.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The writer boxes the voxels that changed, whatever changed them. */
class ChangedVoxelsTest {
  private static final int EDGE = 16;

  private final EditQueue edits = new EditQueue(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), 1);
  private final VoxelWriter writer =
      new VoxelWriter(
          new CollisionScene(List.of(new BitCube(EDGE, EDGE, EDGE))), (segment, box) -> {});

  @Test
  void theBoxHoldsWrittenAndUndoneVoxelsUntilItIsCleared() {
    apply(new VoxelEdit(0, 1, 2, 3, true));
    assertBox(1, 2, 3, 1, 2, 3);
    apply(new VoxelEdit(0, 9, 1, 4, true));
    assertBox(1, 1, 3, 9, 2, 4);
    writer.clearChanged();
    apply(new VoxelEdit(0, 9, 1, 4, true));
    assertTrue(writer.changed().isEmpty(), "it was solid already");
    apply(HistoryEdit.undo());
    assertBox(9, 1, 4, 9, 1, 4);
    writer.clearChanged();
    apply(HistoryEdit.undo());
    assertBox(1, 2, 3, 1, 2, 3);
    apply(HistoryEdit.redo());
    apply(HistoryEdit.redo());
    assertBox(1, 1, 3, 9, 2, 4);
  }

  @Test
  void theBoxOfASwapIsTheWholeCube() {
    apply(new SwapEdit(0, new BitCube(EDGE, EDGE, EDGE)));
    assertBox(0, 0, 0, EDGE - 1, EDGE - 1, EDGE - 1);
  }

  private void apply(Edit edit) {
    assertTrue(edits.offer(edit));
    edits.applyTo(writer, Integer.MAX_VALUE);
  }

  private void assertBox(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    IntBox box = writer.changed();
    int[] low = {lowX, lowY, lowZ};
    int[] high = {highX, highY, highZ};
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(low[axis], box.low(axis), "low end along axis " + axis);
      assertEquals(high[axis], box.high(axis), "high end along axis " + axis);
    }
  }
}
