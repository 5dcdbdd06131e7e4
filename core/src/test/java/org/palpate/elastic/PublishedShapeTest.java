package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.sync.Accumulator;
import org.palpate.sync.Property;

class PublishedShapeTest {
  private static final double TOLERANCE_VOXELS = 1e-9;

  private final GridMetric metric = new GridMetric(1, 1, 1.5);
  private final ElasticTouch touch =
      new ElasticTouch(ElasticTouch.Scene.block(metric), 20e3, 0.5, 8, true);
  private final Accumulator accumulator = new Accumulator();
  private final PublishedShape shape = touch.body.publish(accumulator);

  /** Publishes the last frame and takes it; returns whether the shape differs. */
  private boolean hand() {
    shape.setFrame();
    accumulator.publish();
    accumulator.take();
    boolean differs = shape.take();
    for (Property property : accumulator.properties()) {
      if (property.isDirty()) {
        property.markApplied();
      }
    }
    return differs;
  }

  @Test
  void everyNodeAndThePointStandWhereTheFrameHasThem() {
    touch.hand.set(48, 48, 52);
    touch.run();
    double deepest = 0;
    for (int n = 0; n < 300; n++) {
      touch.moveTo(48 + 8 * Math.sin(0.02 * n), 48, 50 - 0.04 * n, 1);
      hand();
      Vec3 at = shape.materialPoint(new Vec3());
      shape.present(at, at);
      Vec3 expected = touch.frame.presentPosition();
      assertTrue(at.sub(expected, new Vec3()).length() < TOLERANCE_VOXELS, at + " " + expected);
      deepest = Math.max(deepest, compareNodes());
    }
    assertTrue(deepest > 1, "displaced by " + deepest + " mm");
  }

  /** Compares with the map of the haptic thread; returns the longest part of a displacement. */
  private double compareNodes() {
    float[] mm = new float[3 * shape.layout().nodeCount()];
    shape.displacementsMm(mm);
    double longest = 0;
    for (int node = 0; node < shape.layout().nodeCount(); node++) {
      for (int axis = 0; axis < 3; axis++) {
        double cells =
            touch.body.contact().map().nodePosition(node, axis)
                - shape.layout().nodeIndex(axis, node);
        double expected = cells * shape.layout().edgeMm(axis);
        assertEquals(expected, mm[3 * node + axis], 1e-5, "node " + node);
        longest = Math.max(longest, Math.abs(expected));
      }
    }
    return longest;
  }

  /** Beside a slide the point alone chooses the blend, while the force stays zero to the bit. */
  @Test
  void aPointThatMovesWithoutAForceChangesABlendedShape() {
    touch.hand.set(40, 48, 52);
    touch.run();
    touch.moveTo(40, 48, 42, 200);
    touch.moveTo(52, 48, 42, 210);
    assertTrue(touch.body.contact().map().field().slideIntervals > 0, "the field is blended");
    touch.moveTo(50, 48, 60, 5);
    hand();
    touch.moveTo(50.4, 48, 60, 1);
    assertEquals(0, touch.body.contact().load().forceNewton.length());
    assertTrue(hand(), "the point has moved along the slide");
    assertTrue(compareNodes() > 0.1, "the shape is still that of the contact");
  }

  @Test
  void theShapeDiffersOnlyIfTheForceOrTheFieldDoes() {
    touch.hand.set(48, 48, 60);
    touch.run();
    hand();
    touch.moveTo(40, 40, 62, 20); // In the air, and before an update.
    assertFalse(hand(), "nothing presses");
    touch.moveTo(40, 40, 44, 200);
    assertTrue(hand(), "the force differs");
  }
}
