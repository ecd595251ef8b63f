n=0
for i=1 to 3
for j=1 to 3
n=n+1
if j=2 then goto skip
next j
skip: next i
print n; j ' (expect j=2, n=6)
for k=1 to 1
next j ' (expect alarm LB0011 column 1)
next k
