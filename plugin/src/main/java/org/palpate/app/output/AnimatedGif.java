package org.palpate.app.output;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/**
 * Writes pictures as an animated GIF that repeats without end. One thread.
 *
 * <p>Reference: GIF89a specification, 1990; the application extension NETSCAPE2.0 for repetition.
 */
public final class AnimatedGif implements AutoCloseable {
  private static final String FORMAT = "javax_imageio_gif_image_1.0";

  /** The least delay that viewers keep to, hundredths of a second. */
  private static final int LEAST_DELAY = 2;

  /** Repeats without end: a block number of 1 and a count of 0 in two bytes. */
  private static final byte[] ENDLESSLY = {1, 0, 0};

  private final ImageOutputStream stream;
  private final ImageWriter writer;
  private boolean begun;

  /** Begins a file; the stream is flushed by {@link #close}, but not closed. */
  public AnimatedGif(OutputStream out) throws IOException {
    stream = ImageIO.createImageOutputStream(out);
    writer = ImageIO.getImageWritersByFormatName("gif").next();
    writer.setOutput(stream);
    writer.prepareWriteSequence(null);
  }

  /** Adds a picture that is shown for some time. */
  public void add(BufferedImage picture, double seconds) throws IOException {
    IIOMetadata metadata =
        writer.getDefaultImageMetadata(
            ImageTypeSpecifier.createFromRenderedImage(picture), writer.getDefaultWriteParam());
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
    IIOMetadataNode control = child(root, "GraphicControlExtension");
    control.setAttribute("disposalMethod", "none");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "FALSE");
    control.setAttribute("transparentColorIndex", "0");
    long hundredths = Math.max(LEAST_DELAY, Math.round(100 * seconds));
    control.setAttribute("delayTime", Long.toString(hundredths));
    if (!begun) {
      child(root, "ApplicationExtensions").appendChild(repetition());
      begun = true;
    }
    metadata.setFromTree(FORMAT, root);
    writer.writeToSequence(new IIOImage(picture, null, metadata), null);
  }

  private static IIOMetadataNode repetition() {
    IIOMetadataNode repeat = new IIOMetadataNode("ApplicationExtension");
    repeat.setAttribute("applicationID", "NETSCAPE");
    repeat.setAttribute("authenticationCode", "2.0");
    repeat.setUserObject(ENDLESSLY.clone());
    return repeat;
  }

  /** Returns a child of a node; creates it if it is missing. */
  private static IIOMetadataNode child(IIOMetadataNode node, String name) {
    for (int n = 0; n < node.getLength(); n++) {
      if (node.item(n).getNodeName().equals(name)) {
        return (IIOMetadataNode) node.item(n);
      }
    }
    IIOMetadataNode child = new IIOMetadataNode(name);
    node.appendChild(child);
    return child;
  }

  /** Ends the file. */
  @Override
  public void close() throws IOException {
    writer.endWriteSequence();
    stream.close();
    writer.dispose();
  }
}
