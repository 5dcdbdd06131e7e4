/**
 * Volume files in, tables and pictures out; the only package that knows file formats.
 *
 * <p>Uses {@code volume}. World millimetres; any one thread.
 */
package org.palpate.io;
