o0001 (part one)
t1 m6
g90 g1 x.5 z.15 f9. (expect moves: line X0.5 Z0.15 F9)
m30
(finally records: tool 1)
