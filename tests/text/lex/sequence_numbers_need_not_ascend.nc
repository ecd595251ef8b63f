O1 (LEX-7: any order, gaps and repeats are legal)
N30 #100=1
N10 #100=#100+1
N10 #100=#100+1
N20 #100=#100+1 (expect #100=4)
M30
