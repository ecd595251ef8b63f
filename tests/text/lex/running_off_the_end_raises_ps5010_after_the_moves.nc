O1 (LEX-5: the blocks before the missing M30 are complete)
G00 X1. (expect moves: rapid X1)
#100=1
(finally alarm PS5010)
(finally #100=1)
