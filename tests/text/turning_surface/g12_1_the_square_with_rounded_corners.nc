(run with: --machine lathe3c)
O1 (Polar interpolation)
G98
G00X120.Z2.C0
G12.1
G01X40.C0.F200 (expect moves: line X40 C0 F200)
C10. (expect moves: line X44.7214 C26.5651)
G03X20.C20.R10. (expect moves: ccw X44.7214 C63.4349 @20,10 XC)
G01X-40. (expect moves: line X56.5685 C135)
C-10.
G03X-20.C-20.I10. (expect moves: ccw X44.7214 C243.4349 @-20,-10 XC)
G01X40.
C0 (expect moves: line X40 C360)
G13.1
G00X60.C0
M30
(finally machine X60 C0)
