(run with: --set #13001=2)
O1 (rounding of the ends must not make a full circle vanish)
G68 X0 Y0 R60.
G00 X70. Y12.
F500
G41 D1 G01 X73. Y8.
G03 X77. Y12. R4.
G03 I-7.
G03 X73. Y16. R4.
G40 G01 X70. Y12.
G69
M30
(finally moves: rapid X24.6077 Y66.6218; line X27.8397 Y68.2199; ccw X27.1077 Y70.9519 @26.1077,69.2199; ccw X27.1077 Y70.9519 @24.6077,66.6218; ccw X24.3756 Y70.2199; line X24.6077 Y66.6218)
