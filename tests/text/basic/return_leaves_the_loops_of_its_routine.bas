n=0
for i=1 to 300
gosub sub
next i
print n; i ' (expect n=300, i=301)
end
sub:
for j=1 to 10
for i2=1 to 10
if j=1 then n=n+1; return
next i2
next j
return
