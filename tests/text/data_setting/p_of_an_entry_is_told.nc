O1 (P would name an axis)
G10 L50
N3401 P1 R00000001 (expect assumed: P is ignored)
G11
M30
