(run with: --set #13001=5)
O1 (CRC-9, CRC-10: the bevel and a tangent as long as the radius, then the arc of radius 5)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y20. (expect moves: line X-5 Y25; line X1 Y27; line X4 Y23)
G03 X16. Y32. I8. J6. (expect moves: ccw X12 Y29 @8,26 XY)
G01 X10. Y40.
G40 Y60.
M30
