O1 (REF-1, REF-3, WCS-6)
G28 X10. Y5. (expect moves: rapid X10 Y5 linear; rapid X0 Y0 nonlinear)
G29 X20. (expect moves: rapid X10 linear; rapid X20 linear)
G53 X30. Y3. (expect moves: rapid X30 Y3 nonlinear)
M30
