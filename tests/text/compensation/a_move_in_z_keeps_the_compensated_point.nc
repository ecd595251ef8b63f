(run with: --set #13001=5)
O1 (CRC-16: Z moves while the tool stands beside the contour, whatever was released before)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
M00
Z-2. (expect moves: line X-5 Y50 Z-2)
X50.
G40 Y60.
Z5. (expect moves: line X50 Y60 Z5)
M30
