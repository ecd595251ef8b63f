O1 (section 8: wherever they stand in the block)
#5241=10.
X1. G91 G55 G01 F100 (expect moves: line X1 F100)
X1. G90 (expect moves: line X11)
M30
