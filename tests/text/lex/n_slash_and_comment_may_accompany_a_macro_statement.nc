O1 (LEX-33: they are not words in this sense)
N1 /2 #100=2 (HALF) (expect #100=2)
M30
