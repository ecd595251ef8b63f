(run with: --machine arm4)
O0001 (the line up to the radius is made, the radius is not)
G01 X200. Y50. F600.
X260. ,R5. (expect alarm OUT_OF_REACH at X260. ,R5.) (expect moves: line X255 Y50)
Y100.
M30
