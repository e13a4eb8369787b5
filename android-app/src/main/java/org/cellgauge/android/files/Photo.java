package org.cellgauge.android.files;

import org.cellgauge.vision.GreyImage;

/** A still photo; its pixels are not to be changed. */
public final class Photo {
    private final String name;
    private final GreyImage luminance;

    /**
     * A photo.
     *
     * @param name its file name, for people and results
     * @param luminance its grey values, kept and not copied
     */
    public Photo(String name, GreyImage luminance) {
        this.name = name;
        this.luminance = luminance;
    }

    /**
     * Its file name.
     *
     * @return for people and results
     */
    public String name() {
        return name;
    }

    /**
     * Its grey values.
     *
     * @return as read, in the orientation in which they are stored
     */
    public GreyImage luminance() {
        return luminance;
    }
}
