(run with: --set #13001=5)
O1 (a hole lies where it is programmed; the offset comes back with the next move)
G90 G00 X-20. Y-10. Z10.
G41 D1 G01 X0 Y0 F200
Y50. (expect moves: line X-5 Y50)
G81 X30. Y30. Z-5. R2. F100 (expect moves: rapid X30 Y30 Z10; rapid X30 Y30 Z2; line X30 Y30 Z-5; rapid X30 Y30 Z10) (expect assumed: cutter compensation)
G80
M30
