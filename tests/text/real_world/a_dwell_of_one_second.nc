O1 (G4X1. as people write it)
G4X1.
G4X300
M30
(finally records: dwell 1; dwell 0.3)
