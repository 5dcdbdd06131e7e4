package org.palpate.benchmarks.accuracy;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.PhantomSlices;

/** A phantom as bits and as grey values, with its analytic surface. */
final class AccuracyScene {
  final Phantom phantom;
  final AnalyticSurface truth;
  final BitCube bits;
  final CollisionScene collisionScene;

  /** The isosurface of the grey values. */
  final GreyIsosurface grey;

  /** The solids that a threshold makes from the grey values. */
  final CollisionScene greyCollisionScene;

  /** Makes a phantom of a kind and an edge. */
  AccuracyScene(String kind, int edge) {
    phantom = Phantom.parse(kind + ":" + edge);
    truth = phantom.analyticSurface().orElseThrow();
    bits = phantom.segments().segments().get(0).bits();
    collisionScene = new CollisionScene(List.of(bits));
    ScalarVolume volume = read(Phantom.parse(kind + ":" + edge + ":grey"));
    grey = new GreyIsosurface(volume, Phantom.HALF_GREY, Phantom.HALF_GREY);
    greyCollisionScene = new CollisionScene(List.of(threshold(volume)));
  }

  private static ScalarVolume read(Phantom phantom) {
    int edge = phantom.edge();
    ScalarVolume volume = ScalarVolume.of(phantom.grid(), Storage.INT16);
    PhantomSlices slices = phantom.slices();
    short[] slice = new short[edge * edge];
    for (int k = 0; k < edge; k++) {
      slices.read(k, slice);
      for (int n = 0; n < slice.length; n++) {
        volume.set(n % edge, n / edge, k, slice[n]);
      }
    }
    return volume;
  }

  private static BitCube threshold(ScalarVolume volume) {
    int edge = volume.grid().sizeX();
    BitCube bits = new BitCube(edge, edge, edge);
    for (int k = 0; k < edge; k++) {
      for (int j = 0; j < edge; j++) {
        for (int i = 0; i < edge; i++) {
          if (volume.value(i, j, k) >= Phantom.HALF_GREY) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
