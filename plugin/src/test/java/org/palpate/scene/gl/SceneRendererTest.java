package org.palpate.scene.gl;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.opengl.GL;
import org.junit.jupiter.api.Test;

class SceneRendererTest {
  @Test
  void reportsAGraphicsCardWithoutMemory() {
    IllegalStateException thrown =
        assertThrows(
            IllegalStateException.class, () -> SceneRenderer.checkMemory(GL.GL_OUT_OF_MEMORY));
    assertTrue(thrown.getMessage().contains("no memory"), thrown.getMessage());
    assertDoesNotThrow(() -> SceneRenderer.checkMemory(GL.GL_NO_ERROR));
  }
}
