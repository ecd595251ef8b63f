O1 (ARC-5: a chord of 10 and radius 4)
G02 X10. Y0 R4. F100 (expect alarm PS0020 at R4.)
M30
(finally moves: none)
