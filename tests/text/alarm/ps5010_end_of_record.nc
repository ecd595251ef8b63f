O1 (PS5010: no M30)
G00 X1.
(finally alarm PS5010)
(finally moves: rapid X1)
