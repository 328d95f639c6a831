#!/bin/sh
# figures.sh BROWN FOLDER, from the top of the project: the five features, shaded and with stripes.
brown=$1 folder=$2 number=1
for shape in plane edge groove half_cylinder ghost_line; do
    for view in shaded zebra; do
        "$brown" examples/brown/$shape.brown --view $view --turn 25 --rise 40 --size 480x360 --quiet \
            -o "$folder/brown${number}_$view.png" || exit 1
    done
    number=$((number + 1))
done
