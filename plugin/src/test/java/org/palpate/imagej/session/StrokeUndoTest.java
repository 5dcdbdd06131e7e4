package org.palpate.imagej.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import ij.Executer;
import ij.ImagePlus;
import ij.WindowManager;
import ij.process.ByteProcessor;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class StrokeUndoTest {
  private final ImagePlus touched = new ImagePlus("touched", new ByteProcessor(4, 4));
  private final AtomicInteger asked = new AtomicInteger();

  private StrokeUndo undo(boolean answer) {
    return new StrokeUndo(
        touched,
        () -> {
          asked.incrementAndGet();
          return answer;
        });
  }

  @AfterEach
  void forgetTheImage() {
    WindowManager.setTempCurrentImage(null);
  }

  @Test
  void imagejsUndoBelongsToTheLastStrokeOfTheStackInFront() {
    WindowManager.setTempCurrentImage(touched);
    assertNull(undo(true).commandExecuting("Undo"));
    assertEquals("Undo", undo(false).commandExecuting("Undo"), "it is ImageJ's turn");
    assertEquals(2, asked.get());
  }

  @Test
  void otherCommandsAndOtherImagesAreImagejs() {
    WindowManager.setTempCurrentImage(touched);
    assertEquals("Invert", undo(true).commandExecuting("Invert"));
    WindowManager.setTempCurrentImage(new ImagePlus("other", new ByteProcessor(4, 4)));
    assertEquals("Undo", undo(true).commandExecuting("Undo"));
    assertEquals(0, asked.get());
  }

  @Test
  void imagejAsksItBeforeItUndoes() {
    WindowManager.setTempCurrentImage(touched);
    StrokeUndo undo = undo(true);
    Executer.addCommandListener(undo);
    try {
      new Executer("Undo").run();
    } finally {
      Executer.removeCommandListener(undo);
    }
    assertEquals(1, asked.get());
  }
}
