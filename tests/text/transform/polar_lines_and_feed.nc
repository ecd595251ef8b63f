O1 (G16: a hexagon corner by corner)
G90 G16
G01 X10. Y0 F100 (expect moves: line X10 Y0)
X10. Y60. (expect moves: line X5 Y8.6603)
X10. Y120. (expect moves: line X-5 Y8.6603)
G15
M30
