O1 (PS0020: R is shorter than half the chord)
G03 X10. Y0 R4. F100 (expect alarm PS0020 at R4.)
M30
