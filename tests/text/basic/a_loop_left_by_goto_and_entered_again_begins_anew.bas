n=0
again: n=n+1
for i=1 to 10
for j=1 to 10
if n<1000 then goto again
next j
next i
print n; i; j ' (expect n=1000, i=11, j=11)
